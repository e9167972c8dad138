#pragma once
// The list of items to draw, without any GL. The view makes it from the replica; only the renderer reads it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/detail.h"
#include "common/appearance.h"
#include "common/image.h"
#include "common/math.h"

namespace prosector {

/// Render mesh, which the renderer caches on the GPU under `id`. A changed `revision` or `positions_revision`
/// makes it upload the content again.
struct DrawMesh {
  std::uint64_t id = 0;
  std::uint64_t revision = 0;            // topology: triangles changed
  std::uint64_t positions_revision = 0;  // positions or normals changed (soft bodies, skinned hands)
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> rest_positions;  // for textures that stick to tissue; empty: positions
  Triangles triangles;
  Vec3 slender = Vec3::Zero();  // long axis of a long thin mesh, such as an instrument; otherwise zero
};

/// Section plane that opens bodies: the side that its normal points to is removed.
struct SectionPlane {
  Vec3 normal = Vec3::UnitZ();  // unit
  double offset = 0;            // m, signed distance of the plane from the origin along the normal

  /// Returns the signed distance of a point (room frame) from the section plane, m; positive on the side that
  /// is removed.
  double height(const Vec3& place) const { return normal.dot(place) - offset; }
  bool operator==(const SectionPlane&) const = default;
};

/// Role of an item in the view: drawn normally, visible only in reflections, or standing for a real object in
/// a camera image.
enum class ItemRole : std::uint8_t {
  itself,
  around,  // visible only in reflections and by the light that it emits
  ground,  // a real surface in the camera image, below other items: it occludes and receives shadows
  real     // a real object in the camera image, in front of other items: it occludes and casts shadows
};

struct DrawItem {
  std::shared_ptr<const DrawMesh> mesh;
  Pose pose;
  Appearance appearance;
  bool casts_shadow = true;
  Affine shape = {};   // applied after `pose`: scale and shear
  double opacity = 1;  // below 1: transparent
  // Its faces have a back side, such as those of a shell; tissue always has one.
  bool seen_from_inside = false;
  double brightness = 1;  // factor of the reflected light
  /// Whether the item is a light shaft, which adds the appearance's colour to the background, with soft
  /// borders. The x of the mesh's rest positions then holds the fraction of the shaft's length: 0 where it
  /// begins, 1 where it ends.
  bool shaft = false;
  /// Whether the mesh's rest positions hold linear RGB colours of the vertices, for instance of measured
  /// values. These are shaded by the view direction only, not by lights.
  bool painted = false;
  std::shared_ptr<const Detail> detail = {};  // coarser lists of the mesh's triangles; null: none
  std::size_t level = 0;  // level of detail, for every camera and shadow; 0: the mesh's own triangles
  // Items with the same number bound one solid, which a section opens; 0: never opened.
  std::uint32_t solid = 0;
  ItemRole showing = ItemRole::itself;
};

/// Returns the triangles with which the item is drawn at its level of detail: the mesh's own ones at level 0,
/// otherwise those of a coarser list.
inline const Triangles& triangles_of(const DrawItem& item) {
  return item.level == 0 || !item.detail ? item.mesh->triangles
                                         : item.detail->coarser.at(item.level - 1).triangles;
}

/// Line with a width in screen space, for axes and overlays. It is drawn after all surfaces, with or without
/// a depth test.
struct DrawLine {
  Vec3 a, b;  // world frame; for `overlay`: normalised device coordinates (x, y in −1…1)
  Vec3 color = Vec3::Ones();
  double width = 2;  // points
  bool overlay = false;
  bool over = false;                 // in the room, but drawn without a depth test
  bool faint_when_occluded = false;  // drawn faintly where occluded
};

/// Filled rectangle with round corners in the overlay over the view, below the overlay's texts.
struct DrawPlate {
  Eigen::Vector2d low, high;  // points from the top left
  Vec3 color = Vec3::Zero();
  double opacity = 1;
  double radius = 0, rim_width = 0;  // points: of the corners, of the border line
  Vec3 rim_color = Vec3::Ones();
};

/// Background that is drawn behind a text so that the text is legible over the view.
enum class TextGround : std::uint8_t {
  plate,   // dark, half transparent, with round corners: legible on any background
  framed,  // a plate with a border in the text's colour
  none
};

/// Margins of a text's background around the text, horizontally and vertically, and minimum distance between
/// the backgrounds of two texts in the room, all in points.
inline constexpr double ground_beside = 5, ground_above = 0.8, text_margin = 2;

/// Text in the overlay, at a point of the room (such as a name above a head), or on a surface in the room. It
/// is UTF-8 in any script. Lines end at '\n'; a '\t' begins the next column, aligned in all lines.
struct DrawText {
  std::string text;
  Vec3 at = Vec3::Zero();  // overlay: points from the top left in x, y; else world frame, m
  bool overlay = true;
  double height = 14;  // em height in points; on a surface: m
  Vec3 color = Vec3::Ones();
  std::optional<Pose> surface =
      {};           // written on this surface: from its origin along +x, lines along −y; `at` is unused
  double wrap = 0;  // maximum line width, in the unit of `height`; 0: unlimited
  /// Minimum em height and maximum height of the whole text, in the unit of `height`. A text higher than
  /// `tallest` shrinks down to `least_height`; if it is still too high, it ends with an ellipsis. A
  /// `least_height` of 0 means that it does not shrink, a `tallest` of 0 that any height is allowed.
  double least_height = 0, tallest = 0;
  bool centred = false;  // centred at its position, each line centred
  TextGround ground = TextGround::plate;
};

/// Render camera of one eye. Its off-axis frustum is given by the tangents of the angles from straight ahead
/// to the four borders.
struct DrawCamera {
  Pose pose;                                                    // looks along −z, +y up
  double left = -0.6, right = 0.6, bottom = -0.45, top = 0.45;  // tangents
  double near = 0.02, far = 30;                                 // m
  int x = 0, y = 0, width = 800, height = 600;                  // viewport, pixels, from the lower left
  bool inset = false;  // drawn over the other cameras: surfaces only, without lines, texts and light shafts
};

/// Camera image behind everything that is drawn, and its position in the view.
struct DrawBackdrop {
  std::shared_ptr<const Image> image;
  std::uint64_t number = 0;  // changes with the image
  // Pixels of the image: position of the view's corner, size of a pixel of the view.
  double left = 0, top = 0, step = 1;
};

struct DrawList {
  std::vector<DrawCamera> cameras;  // one, or two for side-by-side stereo; then insets
  std::vector<DrawItem> items;
  std::vector<LightInfo> lights;
  std::vector<DrawLine> lines;
  std::vector<DrawPlate> plates;
  std::vector<DrawText> texts;
  std::optional<SectionPlane> section;  // opens all solids
  std::optional<DrawBackdrop> backdrop = {};
  Vec3 ambient = {0.175, 0.18, 0.183};  // radiance of the ceiling between its light panels
  Vec3 background = {0.05, 0.06, 0.07};
  /// Pixels per point. Widths of lines, texts and overlays are measured in points; on a display of standard
  /// density, a point is 1 pixel.
  double scale = 1;
  double strip = 0;      // points at the lower border that other overlays keep clear
  Catalogue words = {};  // language of the texts added by overlays
};

/// Returns whether the list's section plane opens the item, which needs a section and a nonzero `solid`.
inline bool is_opened(const DrawItem& item, const DrawList& list) {
  return list.section && item.solid != 0;
}

}  // namespace prosector
