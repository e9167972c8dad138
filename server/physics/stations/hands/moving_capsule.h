#pragma once
// A capsule that a hand moves within a tick, and what it meets on its path.

#include <optional>
#include <vector>

#include "server/physics/stations/hands/capsule_touch.h"

namespace prosector {

/// Path of a hand's centre within a tick: a translation and a rotation about the centre, both even in time.
struct HandPath {
  Pose centre;                      // at the start
  Vec3 translation = Vec3::Zero();  // m
  Vec3 rotation = Vec3::Zero();     // rad, about the centre
  /// Returns the centre's pose after that share of the tick, 0 … 1.
  Pose at(double share) const;
};

/// A capsule on a hand's path.
class MovingCapsule {
 public:
  /// Stores a capsule with the pose `in_hand` in the frame of the hand's centre. `known`: m, gap below which
  /// other detection finds contacts at the start.
  MovingCapsule(const Capsule& shape, const Pose& in_hand, const HandPath& path, double known);

  /// Returns whether the capsule moves farther than contact detection looks ahead.
  bool is_fast() const;
  /// Returns whether the bounding box of the body is within the capsule's reach.
  bool may_meet(const contact::Collider& body) const;
  /// Removes from the path what moves the capsule farther into the body, if it touches it.
  void slide_along(const contact::Collider& body);
  /// Returns the contacts that the capsule makes on its path with a body that stands still: none if it
  /// already touches the body, or does not reach it. Else the contact of the first touch, found by
  /// conservative advancement, and those of the capsule's ends, which a rotation about the first can bring
  /// closer. The normals are those at the first touch, and the gaps (m) are along them at the start. Sets the
  /// points, normals and gaps only.
  std::vector<rigid::RigidContact> first_touch(const contact::Collider& body) const;

 private:
  double radius() const { return shape_.length / 2 + shape_.radius; }
  void measure();
  double nearest(const Pose& centre, const contact::Collider& body) const;
  rigid::RigidContact touch_at(const Pose& centre, const contact::Collider& body, double along) const;
  std::optional<double> share_until_touch(const contact::Collider& body) const;

  Capsule shape_;
  Pose in_hand_;
  HandPath path_;
  double known_;       // m
  double length_ = 0;  // m: bound of the way of the capsule's points
};

}  // namespace prosector
