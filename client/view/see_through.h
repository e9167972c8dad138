#pragma once
// The scene on a real table that a camera sees: what is real isn't drawn, hides what is behind it, takes
// shadows; virtual things are lit as the table is.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "client/view/draw_list.h"
#include "common/mesh.h"
#include "common/messages.h"

namespace prosector {

/// A real body whose place was found apart from the scene.
struct FoundPhantom {
  std::string body;                                // of the scene, whose shape it has; empty: `shape` says
  std::shared_ptr<const TriangleMesh> shape = {};  // null: the body's
  std::optional<Pose> place = {};  // of the shape in the room; nullopt: as the scene has the body
};

/// A camera's picture to be drawn over.
struct SeeThrough {
  DrawCamera camera;  // that took it
  std::optional<DrawBackdrop> backdrop = {};
  bool is_placed = false;                  // it is known from where it was taken
  Pose room_board = {};                    // of the board on the table
  std::optional<Pose> room_tablet = {};    // of the looker's own panel, as the picture shows it
  std::optional<Vec3> paper = {};          // light of the board's paper, as a screen shows it
  std::vector<std::string> phantoms = {};  // names of bodies that are really there, as the scene has them
  std::optional<FoundPhantom> found = {};  // a further one
  std::string words = {};                  // on the picture; empty: none
};

/// Checks the names of real bodies; `found`: of a FoundPhantom, or empty. Throws InputError that lists the
/// scene's bodies where it has none of that name, and where what was found is soft.
void check_phantoms(const SceneInfo& scene, std::span<const std::string> names, const std::string& found);

/// Returns the light (shown by a screen, linear) that our pictures would have of paper at a place that faces
/// `normal`. Shadows, and what the room's walls send, are left out.
Vec3 shown_paper(const DrawList& list, const Vec3& place, const Vec3& normal);

/// Changes how bright and of which colour the item is, so that its light is the paper's. Our pictures would
/// have the paper as `shown`; the camera has it as `paper`.
void light_as(DrawItem& item, const Vec3& shown, const Vec3& paper);

/// Makes the plane that the board lies in: ground, as large as tables are.
DrawItem table_plane(const Pose& room_board, std::uint64_t mesh_id);

/// Adds the words to the middle of the picture.
void add_words_over(DrawList& list, const std::string& words);

}  // namespace prosector
