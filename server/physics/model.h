#pragma once
// The compiled scene: const while running, but for how stiff tissue is and whether it is attached, which its
// Part says (SoftBody::set_in_force): restored with the state.

#include <memory>
#include <optional>
#include <vector>

#include "common/hash.h"
#include "common/scene/scene.h"
#include "server/physics/collision/fidelity.h"
#include "server/physics/contact/signed_distance.h"
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

/// How a soft body collides.
struct SoftCollision {
  Fidelity fidelity = Fidelity::mesh;
  CollisionMask mask;
  RoomSides passes = 0;  // of the room: it goes through these
  bool continuous = false;
  bool with_itself = false;
  double cell = 0;  // m, of what meets itself: mean edge of its surface as compiled
};

struct Model {
  SceneDesc scene;
  double h = 0;  // s, one tick
  std::vector<RigidModel> rigid;
  std::vector<std::unique_ptr<SoftBody>> soft;
  std::vector<SoftCollision> soft_collision;  // of each
  std::array<HandModel, 2> hands;
  std::vector<RoomModel> room;
  ContentHash hash{};

  /// Stiffness of a contact at a surface vertex, N/m: the body's own over one surface cell, times the
  /// scene's factor.
  double contact_stiffness(std::size_t soft_body, std::size_t vertex) const;
};

/// Throws InputError for what the scene got wrong.
Model compile(const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
