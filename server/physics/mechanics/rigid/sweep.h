#pragma once
// Sweep of fast rigid bodies along their path within a step, so that they stop at what they would pass
// through. Only for the .cpp files of this folder.

#include <vector>

#include "server/physics/mechanics/rigid/bullet_types.h"

namespace prosector::rigid {

/// Bodies that meet others within a step of `h` s. They stop there, and keep their velocity for the contact
/// that the next step finds.
class StoppedBodies {
 public:
  /// Creates an empty set. `filter` decides which objects of the world collide.
  StoppedBodies(btCollisionWorld& world, btOverlapFilterCallback& filter, double h)
      : world_(world), filter_(filter), h_(h) {}

  /// Sweeps a body if its points move by at least `half_thickness` (m, half of its least extent) in the step.
  /// Objects that it overlaps at the start stop it only where it is deeper in them by half of
  /// `half_thickness`. Objects to which it moves by less than `half_thickness` don't stop it, since ordinary
  /// detection finds them in time. Other objects are taken to move on at their current velocity, without
  /// rotation.
  void sweep(btRigidBody& body, double half_thickness);

  /// Multiplies the velocities of the bodies that meet something by the fraction of the step until then.
  void slow_down() const;
  /// Reverses slow_down().
  void give_velocities_back() const;

 private:
  struct Stopped {
    btRigidBody* body;
    btVector3 linear, angular;  // velocities before
    btScalar share;             // of the step
  };

  btCollisionWorld& world_;
  btOverlapFilterCallback& filter_;
  double h_;
  std::vector<Stopped> stopped_;
};

}  // namespace prosector::rigid
