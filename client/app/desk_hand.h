#pragma once
// The hand of a desk user: its fingertips are on the ray through the pointer, its wrist turns about them.

#include "client/view/pick.h"
#include "common/math.h"

namespace prosector {

class DeskHand {
 public:
  /// Puts the hand flat, `reach` from the eye (m).
  void begin(double reach) { reach_ = reach; }
  /// Moves the hand farther away, m.
  void reach(double by);
  /// Turns the wrist, rad. `roll` is about what is straight ahead, clockwise as the user sees it, so that an
  /// instrument that was taken up lying stays level. `bend` lifts the fingers.
  void turn(double roll, double bend);
  void close(bool closed) { closed_ = closed; }
  bool closed() const { return closed_; }
  /// Bends or opens the fingers, which take a while.
  void advance(double seconds);

  double flexion() const { return flexion_; }  // of every finger, 0 … 1
  /// Returns the pose of the wrist in the world frame. `yaw` is that of the view, rad.
  Pose pose(const Ray& pointer, double yaw) const;

 private:
  double reach_ = 0;            // m from the eye to the fingertips
  double roll_ = 0, bend_ = 0;  // rad
  bool closed_ = false;
  double flexion_ = 0.1;
};

}  // namespace prosector
