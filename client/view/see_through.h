#pragma once
// The scene on a real table in a camera image. Real objects are not drawn, but occlude and receive shadows.
// Virtual objects are lit like the table.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/view/draw_list.h"
#include "common/math.h"
#include "common/mesh.h"
#include "common/scene_messages.h"

namespace prosector {

/// A real object whose pose was detected independently of the scene.
struct FoundPhantom {
  std::string body;  // body of the scene with the same shape; empty: see `shape`
  std::shared_ptr<const TriangleMesh> shape = {};  // null: the body's shape
  std::optional<Pose> place = {};  // pose of the shape in the room; nullopt: that of the scene's body
};

/// A camera image to draw over.
struct CameraOverlay {
  DrawCamera camera;  // the camera that took the image
  std::optional<DrawBackdrop> backdrop = {};
  bool is_placed = false;                  // the camera's pose is known
  Pose room_board = {};                    // pose of the marker board on the table
  std::optional<Pose> room_tablet = {};    // pose of the local user's panel in the image
  std::optional<Vec3> paper = {};          // colour of the board's paper in the image, display values
  std::vector<std::string> phantoms = {};  // bodies of the scene that really exist, by name
  std::optional<FoundPhantom> found = {};  // a further phantom
  std::string words = {};                  // text over the image; empty: none
};

/// Checks the names of real bodies; `found`: name of a FoundPhantom, or empty. Throws InputError that lists
/// the scene's bodies if a name is unknown. Throws if the found phantom is soft.
void check_phantoms(const SceneInfo& scene, std::span<const std::string> names, const std::string& found);

/// Returns the displayed colour (linear) that our renderer would give to paper at a position with the given
/// `normal`. Shadows and the light from the walls are neglected.
Vec3 rendered_paper_color(const DrawList& list, const Vec3& place, const Vec3& normal);

/// Adjusts the item's brightness and tint to match the paper's light: `shown` is the rendered paper, `paper`
/// the paper in the camera image.
void match_lighting(DrawItem& item, const Vec3& shown, const Vec3& paper);

/// Makes the plane of the board as ground, as large as a table.
DrawItem table_plane(const Pose& room_board, std::uint64_t mesh_id);

/// Adds the words in the middle of the view.
void add_centred_text(DrawList& list, const std::string& words);

}  // namespace prosector
