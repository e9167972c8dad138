#pragma once
// The rigid world: Bullet's collision detection, islands, constraint solver and pose integration, cut into
// the phases of our step. Bullet solves the islands that hold rigid bodies only; the others are handed out,
// contacts included, and come back as solved velocities. Poses are integrated once, by Bullet, for all.
//
// Frames: a body's frame here is its centre of mass with principal axes. Bullet computes in float.

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/hash.h"
#include "server/physics/collision/broad/collision_mask.h"
#include "server/physics/collision/shapes/shape.h"
#include "server/physics/rigid/room.h"

namespace prosector {

struct RigidSetup {
  std::vector<ShapePart> parts;
  double mass = 0;              // kg; 0: part of the room, never moves
  Vec3 inertia = Vec3::Zero();  // kg·m², principal
  double friction = 0.5;
  double rolling_resistance = 0;  // rolling.h
  double restitution = 0;
  bool hand = false;      // no gravity, never sleeps, passes through other hands
  bool balanced = false;  // no gravity, and a resistance that soon stops it
  CollisionMask mask;
  RoomSides passes = 0;  // of the room: it goes through these
  bool continuous =
      false;  // stopped at the time of impact, where its shape is one convex piece around its centre
};

/// How a body takes part: as its setup says, held where it is as if it were part of the room, or not at all.
enum class BodyPresence : std::uint8_t { free, fixed, absent };

struct RigidMotion {
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero(), angular_velocity = Vec3::Zero();  // m/s, rad/s, world frame
  bool asleep = false;
  double quiet_seconds = 0;
};

/// One point where two rigid bodies touch or nearly do.
struct RigidContact {
  std::size_t a, b;       // slots
  Vec3 point_a, point_b;  // world frame, on either surface
  Vec3 normal;            // unit, from b to a
  double gap;             // m, < 0 penetrates
  double friction, restitution;
  int part_a, part_b;  // of RigidSetup::parts, where a body has several
};

/// What a contact gave a body.
struct RigidImpulse {
  Vec3 point, impulse;  // m, N·s; world frame
};

/// An island that Bullet left to the coupled solver.
struct MixedIsland {
  std::vector<std::size_t> bodies;  // slots of dynamic bodies, ascending
  std::vector<RigidContact> contacts;
};

class RigidWorld {
 public:
  /// Makes an empty world. `room`: what collides of the room around the bodies. Side i is told of in contacts
  /// as room_slot(i), and is asked about by it: dynamic(), mask() and driven_to() know it.
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
  /// Sets how a body takes part; one that becomes fixed or absent stops.
  void set_presence(std::size_t slot, BodyPresence presence);
  BodyPresence presence(std::size_t slot) const;
  const CollisionMask& mask(std::size_t slot) const;

  RigidMotion motion(std::size_t slot) const;
  void set_motion(std::size_t slot, const RigidMotion& motion);
  void set_velocity(std::size_t slot, const Vec3& linear, const Vec3& angular);
  void wake(std::size_t slot);
  enum class Sleep : std::uint8_t { at_once, with_neighbours };
  /// Stops the body and puts it to sleep; or lets Bullet do so at the next find_islands(), with all that it
  /// touches, if these may sleep, too.
  void sleep(std::size_t slot, Sleep when = Sleep::at_once);
  /// Keeps a body that touches something awake that Bullet doesn't know from going to sleep by itself.
  void stay_awake(std::size_t slot);
  /// Takes a fixed body to a pose within the next step of h s, whatever is in its way.
  void drive(std::size_t slot, const Pose& to, double h);
  /// Returns where drive() takes the body in the step that is under way.
  const std::optional<Pose>& driven_to(std::size_t slot) const;
  void set_part_pose(std::size_t slot, std::size_t part, const Pose& pose);
  /// Makes two bodies pass through each other from now on, or collide again.
  void set_collides(std::size_t a, std::size_t b, bool collides);
  /// Returns the box around the body, grown by `margin`: lowest and highest corner.
  std::pair<Vec3, Vec3> bounds(std::size_t slot, double margin) const;

  // ---- One step, in this order
  /// Predicts, then finds pairs and contact points.
  void detect(double h);
  /// Finds islands, transitive through contacts and `links`. `coupled` slots make their island a mixed one.
  void find_islands(std::span<const std::pair<std::size_t, std::size_t>> links,
                    std::span<const std::size_t> coupled);
  /// Solves the rigid islands; returns the mixed ones.
  const std::vector<MixedIsland>& solve(double h);
  /// Returns the velocities after the tick if nothing touched the body: gravity and gyroscopic moment.
  std::pair<Vec3, Vec3> predicted_velocity(std::size_t slot, double h) const;
  /// Integrates poses from the velocities; kinematic bodies arrive and stand still again.
  void integrate(double h);

  /// Returns what contacts gave the body in the last solve(), friction too, if its island was not a mixed
  /// one.
  std::vector<RigidImpulse> impulses(std::size_t slot) const;
  /// Hashes what the next step reads: motions and the cached contact points with their warm starts.
  void hash(StateHasher& hasher) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace prosector
