#pragma once
// Input of a desk user's hand in each frame.

#include <functional>
#include <optional>

#include "client/view/blade_frame.h"
#include "client/view/draped_line.h"
#include "client/view/pick.h"
#include "common/math.h"

namespace prosector {

/// Input of a desk user's hand (driven by the mouse) in each frame: pointer, surface below it, simulated
/// hand, and held instrument.
struct HandGuide {
  Ray pointer;
  Vec3 back = Vec3::UnitZ();      // unit vector, out of the image towards the viewer
  double yaw = 0, pitch = 0;      // rad, angles of the view
  std::optional<double> surface;  // m along the pointer's ray; nullopt: the ray hits nothing
  bool soft = false;              // the surface belongs to a soft body
  double level = 0;               // y component of the surface normal: 1 for a surface facing up
  /// Function that returns the distance, m, from a point (m, world frame) to the next surface along the eye's
  /// ray through it. It is negative if the surface is in front of the point; nullopt if there is none. An
  /// empty function means that no surfaces are near.
  std::function<std::optional<double>(const Vec3&)> gap;
  bool still = false;            // the fingertips keep their position
  std::optional<Pose> physical;  // pose of the simulated wrist
  bool is_paused = false;        // simulated time does not advance
  std::optional<Vec3> tip;       // tip of the instrument in the hand, wrist frame, m
  // If the instrument is a blade:
  std::optional<BladeFrame> blade;  // in the wrist frame
  bool at_blade = false;            // the pointer is on a blade that can be grasped
  std::optional<Picked> tissue;     // point under the pointer, if that tissue can be cut
  FindSurface find;                 // finds the surface of the tissue that can be cut
  Vec3 right = Vec3::UnitX();       // unit vector, the image's right, world frame
};

// m: tolerances for the hand and the simulated hand, which rests on surfaces, to have reached the target.
inline constexpr double target_tolerance = 0.005, physical_tolerance = 0.03;

}  // namespace prosector
