#pragma once
// The compiled scene: const while running. Soft bodies change as they are cut, so they are handed over to the
// state (bodies.h).

#include <memory>
#include <optional>
#include <vector>

#include "common/hash.h"
#include "common/scene/scene.h"
#include "server/physics/collision/outlines/rigid_outline.h"
#include "server/physics/contact/signed_distance.h"
#include "server/physics/contact/soft_collision.h"
#include "server/physics/organs/blade.h"
#include "server/physics/rigid/rigid_world.h"
#include "server/physics/simulation.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {

/// A rigid thing's parts with their distances, in its centre-of-mass frame.
struct RigidShape {
  std::vector<ShapePart> parts;
  std::vector<std::unique_ptr<SignedDistance>> distances;
};

struct RigidModel {
  std::string name;
  TriangleMesh surface;  // body frame
  RigidShape shape;
  RigidSetup setup;
  Pose center;  // centre-of-mass frame in the body's frame
  Pose start;   // body's frame in the room

  /// A plane along which it breaks, and what it breaks into; centre-of-mass frame.
  struct Fracture {
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();
    std::size_t above = 0, below = 0;  // pieces: on the side that the normal points to, and the other
    double mass_above = 0;             // kg
    Vec3 center_above = Vec3::Zero(), center_below = Vec3::Zero();
  };
  std::vector<Fracture> fractures;
  std::optional<std::size_t> whole;  // the body that this is a piece of
};

/// The physical hand of one side: palm, then the segments in joint order.
struct HandModel {
  RigidShape shape;
  RigidSetup setup;
  Pose center;  // centre-of-mass frame in the wrist's frame
};

/// Poses of a hand's parts in its centre-of-mass frame.
std::vector<Pose> hand_part_poses(std::size_t hand, const std::array<double, fingers>& flexion,
                                  const Pose& center);

HandModel make_hand_model(std::size_t hand, const HandDesc& desc);

/// A side of the room as soft bodies meet it; its frame is the room's.
struct RoomModel {
  RoomSide side;
  RigidShape shape;
};

struct Model {
  SceneDesc scene;
  double h = 0;  // s, one tick
  std::vector<RigidModel> rigid;
  std::vector<BladeShape> blades;  // per rigid body of the scene
  std::array<HandModel, 2> hands;
  std::vector<RoomModel> room;
  /// Outlines for soft bodies that collide as simple shapes: per rigid body, of each hand, of the room's
  /// sides. Empty where there is no such body.
  std::vector<std::optional<RigidOutline>> outlines;
  ContentHash hash{};
};

/// A soft body as compiled, at rest.
struct CompiledTissue {
  std::unique_ptr<SoftBody> solver;
  SoftCollision collision;
};

struct CompiledScene {
  Model model;
  std::vector<CompiledTissue> soft;
};

/// Throws InputError for what the scene got wrong.
CompiledScene compile(const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
