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

namespace prosector::rigid {

/// Physical properties of a rigid body of the rigid world: collision parts, mass, inertia, friction and which
/// objects it collides with.
struct RigidSetup {
  std::vector<collision::ShapePart> parts;
  double mass = 0;              // kg; 0: fixed to the room
  Vec3 inertia = Vec3::Zero();  // kg·m², principal
  double friction = 0.5;
  double rolling_resistance = 0;  // see rolling.h
  double restitution = 0;
  bool hand = false;      // a hand: no gravity, never sleeps, no collisions with other hands
  bool balanced = false;  // no gravity, and strong damping
  collision::CollisionMask mask;
  RoomSides passes = 0;  // sides of the room that the body passes through
  /// Whether motion of the body is swept for contacts with tissue (continuous collision detection). Motion
  /// towards rigid bodies is swept whenever it is fast.
  bool continuous = false;
};

/// Presence of a body in the rigid world. `free`: as in its RigidSetup, which may itself be fixed. `fixed`:
/// immobile in the room. `absent`: immobile and without collisions.
enum class BodyPresence : std::uint8_t { free, fixed, absent };

struct RigidMotion {
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();  // m/s, rad/s, world frame
  bool asleep = false;
  double quiet_seconds = 0;
};

/// Contact point of two rigid bodies that touch or nearly touch, in the world frame.
struct RigidContact {
  std::size_t a, b;       // slots
  Vec3 point_a, point_b;  // world frame, on the surface of a and b
  Vec3 normal;            // unit, from b to a
  double gap;             // m, < 0 penetrates
  double friction, restitution;
  int part_a, part_b;  // index in RigidSetup::parts, if a body has several parts
};

/// Impulse that a contact exerted on a rigid body in the last step, with its point of action.
struct RigidImpulse {
  Vec3 point, impulse;  // m, N·s; world frame
};

/// Island (bodies connected by contacts or links) that also contains soft bodies or hands, or in which a body
/// touches one of less than half of its mass. Bullet does not solve it; the coupled solver does.
struct MixedIsland {
  std::vector<std::size_t> bodies;  // slots of dynamic bodies, ascending
  std::vector<RigidContact> contacts;
};

/// World of all rigid bodies, stepped by Bullet. Each body has a slot, an index that stays the same until the
/// body is removed.
class RigidWorld {
 public:
  /// Creates a world without bodies. `gravity` in m/s². `room`: the sides of the room with which bodies
  /// collide. In contacts, side i has the slot room_slot(i); dynamic(), mask() and driven_to() accept that
  /// slot.
  explicit RigidWorld(const Vec3& gravity, std::span<const RoomSide> room = {});
  ~RigidWorld();
  RigidWorld(RigidWorld&&) noexcept;
  RigidWorld& operator=(RigidWorld&&) noexcept;

  /// Adds a body in the lowest free slot, and returns the slot.
  std::size_t add(const RigidSetup& setup, const RigidMotion& motion);
  void remove(std::size_t slot);
  std::size_t slots() const;
  bool used(std::size_t slot) const;
  bool dynamic(std::size_t slot) const;
  /// Makes a body free, fixed in the room, or absent (see BodyPresence). If this changes its presence, the
  /// body's velocity becomes zero and it is awake.
  void set_presence(std::size_t slot, BodyPresence presence);
  BodyPresence presence(std::size_t slot) const;
  const collision::CollisionMask& mask(std::size_t slot) const;

  /// Rounding of a rotation that Bullet stores as a matrix of floats. `none`: set_motion() with this rotation
  /// gives a body the same matrix again, so that a state that is saved, loaded and saved again is the same.
  enum class Rounding : std::uint8_t { to_floats, none };
  RigidMotion motion(std::size_t slot, Rounding rounding = Rounding::to_floats) const;
  void set_motion(std::size_t slot, const RigidMotion& motion);
  void set_velocity(std::size_t slot, const Vec3& linear, const Vec3& angular);
  void wake(std::size_t slot);
  enum class Sleep : std::uint8_t { at_once, with_neighbours };
  /// Sets the body's velocity to zero and puts it to sleep (excludes it from the simulation until it is
  /// touched). With `with_neighbours`, it falls asleep only at the next find_islands(), and only if all
  /// bodies in its island may sleep, too. Does nothing for hands, which never sleep.
  void sleep(std::size_t slot, Sleep when = Sleep::at_once);
  /// Keeps a body awake in this step. To be called while the body touches something unknown to Bullet, such
  /// as tissue.
  void stay_awake(std::size_t slot);
  /// Makes a fixed body move to the pose `to` within the next step of `h` s, as a kinematic body that no
  /// obstacle stops.
  void drive(std::size_t slot, const Pose& to, double h);
  /// Returns the pose to which drive() moves the body in the current step; empty if the body is not driven.
  const std::optional<Pose>& driven_to(std::size_t slot) const;
  void set_part_pose(std::size_t slot, std::size_t part, const Pose& pose);
  /// Enables or disables collisions between the bodies in slots `a` and `b`, and discards their cached
  /// contact points.
  void set_collides(std::size_t a, std::size_t b, bool collides);
  /// Returns the lowest and the highest corner of the body's axis-aligned bounding box, enlarged by `margin`
  /// on each side; m, world frame.
  std::pair<Vec3, Vec3> bounds(std::size_t slot, double margin) const;

  // ---- One step, in this order
  /// Predicts all motions over a step of `h` s, then finds overlapping pairs of bodies and their contact
  /// points. First phase of a step.
  void detect(double h);
  /// Groups the bodies into islands: bodies connected by contacts or by `links`, which are pairs of slots. An
  /// island with a body in `coupled` (slots), or with a contact of two bodies of very different mass, is a
  /// mixed one, which Bullet does not solve. Bodies in `coupled` don't fall asleep in this step. Second
  /// phase.
  void find_islands(std::span<const std::pair<std::size_t, std::size_t>> links,
                    std::span<const std::size_t> coupled);
  /// Solves the contacts of islands that are not mixed, for a step of `h` s. Returns the mixed islands, which
  /// the caller must solve. Third phase of a step.
  const std::vector<MixedIsland>& solve(double h);
  /// Returns the linear (m/s) and the angular velocity (rad/s) that a body would have after a step of `h` s
  /// without contacts, from gravity and gyroscopic moment only. World frame.
  std::pair<Vec3, Vec3> predicted_velocity(std::size_t slot, double h) const;
  /// Integrates the poses of all bodies from their velocities over `h` s. A free body that moves by more than
  /// half of its thickness stops where it would enter another body, and keeps its velocity; hands don't.
  /// Bodies moved by drive() reach their target pose and stop. Last phase of a step.
  void integrate(double h);

  /// Returns the contact impulses, friction included, that the last solve() applied to the body. They are
  /// valid only if Bullet solved the body's island, so not for a mixed one.
  std::vector<RigidImpulse> impulses(std::size_t slot) const;
  /// Adds to the hasher the state of all bodies that the next step reads: poses, velocities and sleep state,
  /// and the distances and warm-start impulses of cached contact points.
  void hash(StateHasher& hasher) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector::rigid
