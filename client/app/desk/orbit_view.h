#pragma once
// Orbit camera: an eye that looks at a target, with limits and animated transitions.

#include <span>

#include "common/math.h"

namespace prosector {

/// Pose of an orbit camera, which looks at a target. The eye is at `distance` from the target, rotated about
/// it by `yaw` about +y and raised by `pitch`. With both 0 it looks along −z.
struct ViewPlace {
  Vec3 target = Vec3::Zero();  // m, world frame
  double yaw = 0, pitch = 0;   // rad
  double distance = 1;         // m

  /// Returns the unit vector (world frame) from the target to the eye.
  Vec3 back() const;
  Vec3 eye() const { return target + distance * back(); }
  /// Returns the eye's pose in the world frame: −z is the viewing direction, +y up.
  Pose pose() const;
  bool is_finite() const;
};

inline constexpr double min_view_distance = 0.05, max_view_distance = 10;  // m from the target
inline constexpr double max_view_pitch = 1.5;        // rad: the view never turns upside down
inline constexpr double max_target_coordinate = 10;  // m from the origin, along each axis
inline constexpr double transition_seconds = 0.25;

/// Returns the orbit pose (target, angles and distance) of an eye that looks at a target, limited to the
/// allowed range; m, world frame. If both positions coincide, the eye is put in front of the target.
ViewPlace place_of(const Vec3& eye, const Vec3& target);
/// Returns the orbit pose limited to the allowed targets, pitch angles and distances.
ViewPlace bounded(ViewPlace place);
/// Returns the orbit pose with this yaw and pitch from which the points (m, world frame) fill the fraction
/// `share` of the frame's width or height, whichever is more. The centre of their bounding box is in the
/// middle. `fov`: vertical, rad; `aspect`: the frame's width over its height.
ViewPlace framed(std::span<const Vec3> points, double yaw, double pitch, double fov, double aspect,
                 double share = 0.6);
/// Returns the orbit pose with this yaw and pitch from which the corners of the box (m, world frame) fill the
/// fraction `share` of the frame's width or height. `fov`: vertical, rad; `aspect`: width over height.
ViewPlace framed(const Eigen::AlignedBox3d& box, double yaw, double pitch, double fov, double aspect,
                 double share = 0.6);

class OrbitView {
 public:
  /// Sets the home pose and the current pose of the camera to `home`, without a transition.
  void begin(const ViewPlace& home);
  const ViewPlace& place() const { return now_; }
  const ViewPlace& home() const { return home_; }
  bool is_under_way() const { return under_way_ < 1; }

  // During a transition each of these changes its goal. Non-finite arguments are ignored.
  /// Rotates the eye about the target by two angles, rad: to the left, and upwards.
  void turn(double left, double up);
  /// Rotates the viewing direction about the eye by two angles, rad: to the right, and downwards. The target
  /// moves instead of the eye.
  void rotate_gaze(double right, double down);
  /// Multiplies the distance between eye and target by `factor`; below 1 the eye comes nearer.
  void zoom(double factor);
  /// Moves eye and target by the vector `by`, m, world frame.
  void move(const Vec3& by);

  /// Starts a smooth transition to another pose, which takes transition_seconds.
  void go_to(const ViewPlace& place);
  void advance(double seconds);

 private:
  ViewPlace home_, now_;
  ViewPlace from_, goal_;
  double under_way_ = 1;  // elapsed fraction of the transition's time; 1: no transition

  ViewPlace& aim() { return under_way_ < 1 ? goal_ : now_; }
  void set(const ViewPlace& place);
};

}  // namespace prosector
