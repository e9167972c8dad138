#pragma once
// The reference of collision detection: all objects, rigid or soft, in one world. Sessions find contacts in
// other ways; what those get wrong is measured against this.

#include <optional>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/broad/broad_phase.h"
#include "tests/collision/reference/collision_object.h"
#include "tests/collision/reference/narrow_phase.h"

namespace prosector {

/// What is known of two objects that touch or nearly do. Where they meet later in the tick (impact > 0),
/// point, normal and the rest are those of then; only the gap is always that of now.
struct ObjectTouch {
  std::uint32_t a = 0, b = 0;   // ids, a < b
  Vec3 point = Vec3::Zero();    // m, room frame
  Vec3 normal = Vec3::UnitY();  // unit, from b to a
  double gap = 0;               // m, < 0: depth
  Vec3 local_a = Vec3::Zero(),
       local_b = Vec3::Zero();         // m: on a and on b, in their frames; soft: in the room's
  collision::SurfacePoint at_a, at_b;  // soft at fidelity mesh: which material point
  std::optional<double> impact;        // s from now: when a continuous pair meets; 0: touches already
};

struct CollisionReport {
  std::vector<ObjectTouch> touches;  // ascending by (a, b)
  std::size_t broad_pairs = 0;
  std::size_t unsettled_impacts = 0;    // time_of_impact stopped before it was sure
  std::vector<std::uint32_t> rejected;  // objects that were given numbers that aren't finite since the last
                                        // detect(); they stay where they were
};

struct CollisionOptions {
  bool moves = true;
  bool continuous = false;  // also find when it meets others within the tick
  collision::CollisionMask mask;
};

/// The same calls find the same touches, bit for bit; what came before doesn't matter.
class CollisionWorld {
 public:
  using Id = std::uint32_t;

  /// `margin`: m, objects that near are told of. Throws InputError unless it is positive and finite.
  explicit CollisionWorld(double margin);

  /// In the lowest free id.
  Id add(CollisionObject object, const CollisionOptions& options = {});
  void remove(Id id);
  const CollisionObject& object(Id id) const { return *entries_[id].object; }
  std::size_t size() const { return size_; }

  void place(Id id, const Pose& pose, const Vec3& linear = Vec3::Zero(), const Vec3& angular = Vec3::Zero());
  void bend(Id id, std::size_t part, const Pose& pose);
  void move(Id id, std::span<const Vec3> positions, std::span<const Vec3> velocities = {});
  void cut(Id id, const TriangleMesh& surface);
  /// Begins or ceases to move: changes tree.
  void set_moves(Id id, bool moves);

  /// Everything that touches now or, where one is continuous, within h seconds.
  const CollisionReport& detect(double h = 0);

  const collision::BroadPhase& broad_phase() const { return broad_; }

 private:
  struct Entry {
    std::optional<CollisionObject> object;
    CollisionOptions options;
    bool changed = false, rejected = false;
  };
  Entry& entry(Id id) { return entries_[id]; }
  void refresh_boxes(double h);
  void detect_pair(Id a, Id b, double h);

  double margin_;
  std::vector<Entry> entries_;
  std::size_t size_ = 0;
  double swept_ = 0;  // s that the boxes are for
  collision::BroadPhase broad_;
  CollisionReport report_;
};

}  // namespace prosector
