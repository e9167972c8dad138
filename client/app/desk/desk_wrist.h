#pragma once
// Rotation of a desk user's wrist.

#include "common/math.h"

namespace prosector {

/// Rotation of the wrist of a desk user's hand: by the view, by the wheel, and by cuts that drive the hand.
class DeskWrist {
 public:
  /// Rotates the wrist by two angles, rad. `bend` raises the direction in which the hand points,
  /// independently of the roll. `roll` is about that direction, clockwise as the user sees it, so an
  /// instrument grasped in a lying position stays level.
  void turn(double roll, double bend);
  /// Turns the hand with the view, whose angle about +y is `view_yaw`, rad.
  void face(double view_yaw);
  /// Rotates the fingers so that the hand covers little of the surface under it. `pitch`: angle of the view,
  /// rad; `level`: y component of the surface normal.
  void lift_fingers(double pitch, double level, double seconds);
  /// Sets the rotation, world frame, to which a cut drives the wrist.
  void follow_cut(const Quat& rotation);
  /// Rotates the wrist towards a rotation, world frame, by at most `angle` rad. Returns whether it is
  /// reached.
  bool rotate_towards(const Quat& rotation, double angle);
  /// Lets the rotation due to cuts decay for a frame of `seconds`.
  void turn_back(double seconds);

  /// Returns the rotation of the wrist, world frame.
  Quat rotation() const { return before_cuts() * rotated_; }

 private:
  double yaw_ = 0, lift_ = -0.5, roll_ = 0,
         bend_ = 0;                  // rad; lift_: elevation of the fingers before the bend
  Quat rotated_ = Quat::Identity();  // rotation of the wrist due to cuts

  Quat before_cuts() const;
};

}  // namespace prosector
