#pragma once
// An eye that looks at a target, within bounds that it can't leave, and its way back home.

#include <span>

#include "common/math.h"

namespace prosector {

/// Where an eye is: `distance` from its target, turned by `yaw` about +y and raised by `pitch`. With both 0
/// it looks along −z.
struct ViewPlace {
  Vec3 target = Vec3::Zero();  // m, world frame
  double yaw = 0, pitch = 0;   // rad
  double distance = 1;         // m

  /// Returns the direction from the target to the eye.
  Vec3 back() const;
  Vec3 eye() const { return target + distance * back(); }
  /// Returns the eye's pose: −z looks ahead, +y up.
  Pose pose() const;
  bool is_finite() const;
};

inline constexpr double nearest_view = 0.05, farthest_view = 10;  // m from the target
inline constexpr double steepest_view = 1.5;                      // rad: the view never turns over
inline constexpr double farthest_target = 10;                     // m from the origin, along each axis
inline constexpr double transition_seconds = 0.25;

/// Returns the place of an eye that looks at a target; of one that is in it, a place in front of it.
ViewPlace place_of(const Vec3& eye, const Vec3& target);
/// Returns the nearest place within the bounds.
ViewPlace bounded(ViewPlace place);
/// Returns the place from which the points, seen with the middle of their box in the middle, take `share` of
/// the picture's width or height, whichever they fill more. `fov` is vertical, rad; `aspect` is the picture's
/// width over its height.
ViewPlace framed(std::span<const Vec3> points, double yaw, double pitch, double fov, double aspect,
                 double share = 0.6);
/// Returns the place for a box's corners.
ViewPlace framed(const Eigen::AlignedBox3d& box, double yaw, double pitch, double fov, double aspect,
                 double share = 0.6);

class OrbitView {
 public:
  /// Begins at home.
  void begin(const ViewPlace& home);
  const ViewPlace& place() const { return now_; }
  const ViewPlace& home() const { return home_; }
  bool is_under_way() const { return under_way_ < 1; }

  // Each of these changes, during a transition, where that leads. Numbers that aren't finite change nothing.
  /// Turns the eye about the target, rad: to its left, and upwards.
  void turn(double left, double up);
  /// Turns the gaze about the eye by the same angles.
  void look_round(double left, double up);
  /// Scales the distance.
  void zoom(double factor);
  /// Moves eye and target, m.
  void move(const Vec3& by);

  /// Goes to another place smoothly, in transition_seconds.
  void go_to(const ViewPlace& place);
  void advance(double seconds);

 private:
  ViewPlace home_, now_;
  ViewPlace from_, goal_;
  double under_way_ = 1;  // share of the transition's time; 1: there is none

  ViewPlace& aim() { return under_way_ < 1 ? goal_ : now_; }
  void set(const ViewPlace& place);
};

}  // namespace prosector
