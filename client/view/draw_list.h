#pragma once
// What to draw, without any GL: made by the view from the replica, consumed only by the renderer.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/detail.h"
#include "common/image.h"
#include "common/math.h"
#include "common/messages.h"

namespace prosector {

/// Geometry that the renderer keeps on the GPU under `id`; a higher `revision` replaces its content.
struct DrawMesh {
  std::uint64_t id = 0;
  std::uint64_t revision = 0;            // topology: triangles changed
  std::uint64_t positions_revision = 0;  // positions or normals changed (soft bodies, skinned hands)
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector3f> rest_positions;  // for textures that stick to tissue; empty: positions
  Triangles triangles;
  Vec3 slender = Vec3::Zero();  // of what is long and thin, as instruments: its long axis; else zero
};

/// A plane that opens bodies: what its normal points to is taken away.
struct SectionPlane {
  Vec3 normal = Vec3::UnitZ();  // unit
  double offset = 0;            // of its points along the normal, m

  /// Returns how far the place is on the side that is taken away, m.
  double height(const Vec3& place) const { return normal.dot(place) - offset; }
  bool operator==(const SectionPlane&) const = default;
};

/// How an item shows in a picture.
enum class Showing : std::uint8_t {
  itself,
  around,  // only in what mirrors it, and by the light that it sends
  ground,  // a camera's picture has it, below other things: it hides what is behind, and takes shadows
  real  // a camera's picture has it, before other things: it hides what is behind, and shades what is drawn
};

struct DrawItem {
  std::shared_ptr<const DrawMesh> mesh;
  Pose pose;
  Appearance appearance;
  bool casts_shadow = true;
  Affine shape = {};              // applied after `pose`: what scales and shears it
  double opacity = 1;             // below 1: what is behind shows through
  bool seen_from_inside = false;  // its faces have a back, as of a shell; those of tissue have one anyway
  double brightness = 1;          // times what light makes of it
  /// Light in air: adds the appearance's colour to what is behind, softly at its rims. The mesh's rest
  /// positions hold in x how far along the light they are: 0 where it begins, 1 where it is gone.
  bool shaft = false;
  /// The mesh's rest positions hold colours (linear), which no light changes but by the eye's direction.
  bool painted = false;
  std::shared_ptr<const Detail> detail = {};  // coarser lists of the mesh's triangles; null: none
  std::size_t level = 0;                      // of them, for every camera and the shadow; 0: the mesh's own
  std::uint32_t solid = 0;  // items of one number bound one solid, which a section opens; 0: stays whole
  Showing showing = Showing::itself;
};

/// Returns the triangles that the item is drawn with.
inline const Triangles& triangles_of(const DrawItem& item) {
  return item.level == 0 || !item.detail ? item.mesh->triangles
                                         : item.detail->coarser.at(item.level - 1).triangles;
}

/// Screen-space line, for axes and overlays; drawn after everything, depth tested or not.
struct DrawLine {
  Vec3 a, b;  // world frame, or for `overlay` normalised device coordinates (x, y in −1…1)
  Vec3 color = Vec3::Ones();
  double width = 2;  // points
  bool overlay = false;
  bool over = false;            // in the room, but drawn over what is before it
  bool shines_through = false;  // faintly seen through what hides it
};

/// A plate in the overlay, below its texts.
struct DrawPlate {
  Eigen::Vector2d low, high;  // points from the top left
  Vec3 color = Vec3::Zero();
  double opacity = 1;
  double radius = 0, rim_width = 0;  // points: of its corners, of a rim
  Vec3 rim_color = Vec3::Ones();
};

/// What a text over a picture stands on.
enum class TextGround : std::uint8_t {
  plate,   // dark, half transparent, with round corners: legible on any picture
  framed,  // a plate with a rim of the text's colour
  none
};

/// Says how far the ground of a text reaches beyond it, in points, and how far apart the grounds of two texts
/// in the room are kept.
inline constexpr double ground_beside = 5, ground_above = 0.8, text_margin = 2;

/// Text in the overlay, at a place in the room (names above heads), or on a surface in the room. UTF-8 in any
/// script. Lines end at '\n'; a '\t' begins the next column, the same for all lines.
struct DrawText {
  std::string text;
  Vec3 at = Vec3::Zero();  // overlay: points from the top left in x, y; else world frame
  bool overlay = true;
  double height = 14;  // of the em, points; on a surface: m
  Vec3 color = Vec3::Ones();
  std::optional<Pose> surface =
      {};           // written on it: from its origin along +x, lines along −y; `at` is unused
  double wrap = 0;  // in the unit of `height`: lines are broken at this width; 0: not
  /// In the unit of `height`: what a text that does not fit below `tallest` shrinks to at most; still too
  /// long, it ends with an ellipsis. 0: it does not shrink; any height.
  double least_height = 0, tallest = 0;
  bool centred = false;  // its middle stands at its place, each line in the middle
  TextGround ground = TextGround::plate;
};

/// One eye's camera. Off-axis frustum: tangents of the four half angles.
struct DrawCamera {
  Pose pose;                                                    // −z looks ahead, +y up
  double left = -0.6, right = 0.6, bottom = -0.45, top = 0.45;  // tangents
  double near = 0.02, far = 30;                                 // m
  int x = 0, y = 0, width = 800, height = 600;                  // viewport, pixels, from the lower left
  bool inset = false;  // drawn over the others: surfaces alone, without lines, texts and light shafts
};

/// A camera's picture behind everything that is drawn.
struct DrawBackdrop {
  std::shared_ptr<const Image> image;
  std::uint64_t number = 0;            // another image has another one
  double left = 0, top = 0, step = 1;  // pixels of the image: of the drawn picture's corner, and of its pixel
};

struct DrawList {
  std::vector<DrawCamera> cameras;  // one, or two for stereo side by side; then insets
  std::vector<DrawItem> items;
  std::vector<LightInfo> lights;
  std::vector<DrawLine> lines;
  std::vector<DrawPlate> plates;
  std::vector<DrawText> texts;
  std::optional<SectionPlane> section;  // that opens all solids
  std::optional<DrawBackdrop> backdrop = {};
  Vec3 ambient = {0.175, 0.18, 0.183};  // radiance of the ceiling beside its light panels
  Vec3 background = {0.05, 0.06, 0.07};
  /// Pixels of a point, in which lines, texts and overlays are measured: 1 on a display of usual density.
  double scale = 1;
  double strip = 0;      // points at the lower border that other overlays leave free
  Catalogue words = {};  // language of the texts that overlays add
};

/// Tells whether the list's section takes a part of the item away, if it reaches it.
inline bool is_opened(const DrawItem& item, const DrawList& list) {
  return list.section && item.solid != 0;
}

}  // namespace prosector
