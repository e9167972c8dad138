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

/// Real object (phantom) in a camera image, whose pose is detected independently of the scene. It occludes
/// virtual objects.
struct FoundPhantom {
  std::string body;  // body of the scene with the same shape; empty: see `shape`
  std::shared_ptr<const TriangleMesh> shape = {};  // null: the body's shape
  std::optional<Pose> place = {};  // pose of the shape in the room; nullopt: that of the scene's body
};

/// Projection over a camera image: the scene is drawn as the camera sees it, with the image as background.
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

/// Checks the names of the scene's bodies that exist in reality (phantoms). `found`: name of the body whose
/// phantom the camera locates, or empty. Throws InputError that lists the scene's bodies if a name is
/// unknown, and InputError if `found` names a soft body.
void check_phantoms(const SceneInfo& scene, std::span<const std::string> names, const std::string& found);

/// Returns the colour (display values, tone-mapped) that the renderer would give to white paper at a position
/// (m, room frame) with this `normal`. Shadows and the light from the walls are neglected.
Vec3 rendered_paper_color(const DrawList& list, const Vec3& place, const Vec3& normal);

/// Adjusts the item's brightness and tint to the real light. `shown` is the colour of white paper as
/// rendered, `paper` that of the real paper in the camera image, both as display values.
void match_lighting(DrawItem& item, const Vec3& shown, const Vec3& paper);

/// Creates the plane of the real table as large as a table, through the board of tags on it, whose room pose
/// is given. As ground, it is not visible but occludes and receives shadows.
DrawItem table_plane(const Pose& room_board, std::uint64_t mesh_id);

/// Adds a text in the middle of the view.
void add_centred_text(DrawList& list, const std::string& words);

}  // namespace prosector
