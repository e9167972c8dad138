#pragma once
// The rigid world: Bullet's collision detection, islands, constraint solver and pose integration, split into
// the phases of the simulation step. Bullet solves the islands with rigid bodies only. Other islands are
// returned to the caller with their contacts; the caller solves them and sets their velocities. Bullet
// integrates all poses once.
//
// Frames: a body's frame here is at its centre of mass, along its principal axes. Bullet computes in float.

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/hash.h"
#include "server/physics/mechanics/collision/broad/collision_mask.h"
#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/rigid/room.h"

namespace prosector {

/// Physical properties of a rigid body.
struct RigidSetup {
  std::vector<ShapePart> parts;
  double mass = 0;              // kg; 0: fixed to the room
  Vec3 inertia = Vec3::Zero();  // kg·m², principal
  double friction = 0.5;
  double rolling_resistance = 0;  // see rolling.h
  double restitution = 0;
  bool hand = false;      // a hand: no gravity, never sleeps, no collisions with other hands
  bool balanced = false;  // no gravity, and strong damping
  CollisionMask mask;
  RoomSides passes = 0;  // sides of the room that the body passes through
  /// Stopped at the time of impact, if its shape is one convex piece around its centre.
  bool continuous = false;
};

/// Presence of a body: as in its setup, fixed in the room, or absent.
enum class BodyPresence : std::uint8_t { free, fixed, absent };

struct RigidMotion {
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();  // m/s, rad/s, world frame
  bool asleep = false;
  double quiet_seconds = 0;
};

/// A point where two rigid bodies touch or nearly touch.
struct RigidContact {
  std::size_t a, b;       // slots
  Vec3 point_a, point_b;  // world frame, on the surface of a and b
  Vec3 normal;            // unit, from b to a
  double gap;             // m, < 0 penetrates
  double friction, restitution;
  int part_a, part_b;  // index in RigidSetup::parts, if a body has several parts
};

/// Impulse of a contact on a body.
struct RigidImpulse {
  Vec3 point, impulse;  // m, N·s; world frame
};

/// An island that Bullet does not solve; the coupled solver does.
struct MixedIsland {
  std::vector<std::size_t> bodies;  // slots of dynamic bodies, ascending
  std::vector<RigidContact> contacts;
};

/// All rigid bodies, stepped by Bullet.
class RigidWorld {
 public:
  /// Creates an empty world. `room`: the colliding sides of the room. Side i has the slot room_slot(i) in
  /// contacts; dynamic(), mask() and driven_to() accept that slot.
  explicit RigidWorld(const Vec3& gravity, std::span<const RoomSide> room = {});
  ~RigidWorld();
  RigidWorld(RigidWorld&&) noexcept;
  RigidWorld& operator=(RigidWorld&&) noexcept;

  /// Adds a body in the lowest free slot.
  std::size_t add(const RigidSetup& setup, const RigidMotion& motion);
  void remove(std::size_t slot);
  std::size_t slots() const;
  bool used(std::size_t slot) const;
  bool dynamic(std::size_t slot) const;
  /// Sets a body's presence; a body that becomes fixed or absent stops.
  void set_presence(std::size_t slot, BodyPresence presence);
  BodyPresence presence(std::size_t slot) const;
  const CollisionMask& mask(std::size_t slot) const;

  RigidMotion motion(std::size_t slot) const;
  void set_motion(std::size_t slot, const RigidMotion& motion);
  void set_velocity(std::size_t slot, const Vec3& linear, const Vec3& angular);
  void wake(std::size_t slot);
  enum class Sleep : std::uint8_t { at_once, with_neighbours };
  /// Stops the body and puts it to sleep. With `with_neighbours`, Bullet puts it to sleep at the next
  /// find_islands(), if all bodies that it touches may sleep, too.
  void sleep(std::size_t slot, Sleep when = Sleep::at_once);
  /// Keeps a body awake that touches something unknown to Bullet.
  void stay_awake(std::size_t slot);
  /// Moves a fixed body to a pose within the next step of h s, whatever is in its path.
  void drive(std::size_t slot, const Pose& to, double h);
  /// Returns the target pose of drive() for the current step.
  const std::optional<Pose>& driven_to(std::size_t slot) const;
  void set_part_pose(std::size_t slot, std::size_t part, const Pose& pose);
  /// Disables or enables collisions between two bodies.
  void set_collides(std::size_t a, std::size_t b, bool collides);
  /// Returns the body's bounding box, grown by `margin`: lowest and highest corner.
  std::pair<Vec3, Vec3> bounds(std::size_t slot, double margin) const;

  // ---- One step, in this order
  /// Predicts motions, then finds overlapping pairs and contact points.
  void detect(double h);
  /// Finds islands: bodies connected by contacts and `links`. Bodies in `coupled` slots make their island a
  /// mixed one.
  void find_islands(std::span<const std::pair<std::size_t, std::size_t>> links,
                    std::span<const std::size_t> coupled);
  /// Solves the rigid islands; returns the mixed islands.
  const std::vector<MixedIsland>& solve(double h);
  /// Returns the velocities after the tick without contacts: with gravity and gyroscopic moment only.
  std::pair<Vec3, Vec3> predicted_velocity(std::size_t slot, double h) const;
  /// Integrates poses from the velocities. Kinematic bodies reach their target and stop.
  void integrate(double h);

  /// Returns the contact impulses on the body in the last solve(), including friction, if its island was not
  /// mixed.
  std::vector<RigidImpulse> impulses(std::size_t slot) const;
  /// Hashes all data that the next step reads: motions and cached contact points with their warm starts.
  void hash(StateHasher& hasher) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
