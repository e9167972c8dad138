#pragma once
// The compiled scene, constant while the simulation runs. Soft bodies change when they are cut, so they are
// moved to the state (bodies.h).

#include <memory>
#include <optional>
#include <vector>

#include "common/hash.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/collision/outlines/rigid_outline.h"
#include "server/physics/mechanics/contact/rigid_shape.h"
#include "server/physics/mechanics/contact/soft_collision.h"
#include "server/physics/mechanics/hands/hand_model.h"
#include "server/physics/mechanics/organs/blade.h"
#include "server/physics/mechanics/rigid/rigid_world.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

struct RigidModel {
  std::string name;
  TriangleMesh surface;  // body frame
  contact::RigidShape shape;
  rigid::RigidSetup setup;
  Pose center;  // centre-of-mass frame, relative to the body's frame
  Pose start;   // body's frame in the room frame

  /// A plane along which a bone breaks, and the two resulting pieces. Positions and the normal are in the
  /// centre-of-mass frame of the unbroken bone.
  struct Fracture {
    Vec3 point = Vec3::Zero(), normal = Vec3::UnitY();
    std::size_t above = 0, below = 0;  // pieces on the side that the normal points to, and on the other side
    double mass_above = 0;             // kg
    Vec3 center_above = Vec3::Zero(), center_below = Vec3::Zero();
  };
  std::vector<Fracture> fractures;
  std::optional<std::size_t> whole;  // of a piece: the unbroken body
};

/// Collision shape of one side of the room for contacts with soft bodies, in the room frame.
struct RoomModel {
  rigid::RoomSide side;
  contact::RigidShape shape;
};

struct Model {
  SceneDesc scene;
  double h = 0;  // s, one tick
  std::vector<RigidModel> rigid;
  std::vector<organs::BladeShape> blades;  // by rigid body of the scene
  std::array<hands::HandModel, 2> hands;
  std::vector<RoomModel> room;
  /// Outlines for contacts with soft bodies that collide as proxy shapes (sphere, box or hull). The order is:
  /// rigid bodies, hands, sides of the room. Empty if the scene has no such soft body.
  std::vector<std::optional<collision::RigidOutline>> outlines;
  ContentHash hash{};
};

/// A soft body as the scene's compilation produces it, at rest: its solver and its collision properties.
struct CompiledTissue {
  std::unique_ptr<soft::SoftBody> solver;
  contact::SoftCollision collision;
};

struct CompiledScene {
  Model model;
  std::vector<CompiledTissue> soft;
};

}  // namespace prosector
