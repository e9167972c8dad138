#pragma once
// Glyphs and their backgrounds as triangles. No GL. Private to client/render.

#include <vector>

#include "client/text/glyph_sheet.h"
#include "common/math.h"

namespace prosector {

using UnalignedVec4f = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;  // without padding after it

struct GlyphVertex {
  static std::vector<int> attributes() { return {4, 3, 2}; }
  UnalignedVec4f at;      // clip coordinates
  Eigen::Vector3f color;  // linear RGB
  Eigen::Vector2f texel;  // on the glyph sheet
};

struct PlateVertex {
  static std::vector<int> attributes() { return {2, 2, 4, 4, 4}; }
  Eigen::Vector2f at;         // normalised device coordinates
  Eigen::Vector2f place;      // pixels from the plate's centre
  Eigen::Vector4f fill, rim;  // linear RGB, opacity
  Eigen::Vector4f shape;      // pixels: half width and height, corner radius, border width
};

/// Axis-aligned rectangle in a view: its borders in pixels from the viewport's top left.
struct ScreenBox {
  double left, top, right, bottom;
};

struct PlateLook {
  Eigen::Vector4f fill, rim;  // linear RGB, opacity
  double radius = 0;          // pixels, of its corners
  double rim_width = 0;       // pixels
};

/// Adds to `out` the two triangles of a glyph, whose image is at `spot` on the glyph sheet. `corners`: top
/// left, top right, bottom right and bottom left, in clip coordinates. `color` is linear RGB.
void add_glyph(std::vector<GlyphVertex>& out, const std::array<Eigen::Vector4d, 4>& corners,
               const GlyphSpot& spot, const Vec3& color);

/// Adds to `out` the two triangles of a plate, a filled rectangle with a border and round corners. `picture`:
/// width and height of the view, pixels.
void add_plate(std::vector<PlateVertex>& out, const ScreenBox& box, const PlateLook& look,
               const Eigen::Vector2d& picture);

/// Returns the clip coordinates of a point given in pixels from the top left of a view. `picture`: width and
/// height of the view, pixels.
Eigen::Vector4d clip_of(const Eigen::Vector2d& pixels, const Eigen::Vector2d& picture);

}  // namespace prosector
