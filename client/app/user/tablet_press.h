#pragma once
// Lets a bare hand operate a tablet in front of a single camera. The hand's depth has an error of about 2 cm,
// while a button's travel is 7 mm. The direction from the camera to the fingertip is accurate, and so is the
// board's pose (docs/decisions/0031). Therefore a pointing finger is moved to the intersection of its ray
// with the board. It presses the control at which it stays, and releases that when it moves away or stops
// pointing.

#include <array>
#include <cstdint>
#include <optional>

#include "common/hand_pose.h"
#include "common/math.h"
#include "common/panel_control.h"

namespace prosector {

class TabletPress {
 public:
  /// Returns the hand's pose corrected so that it operates the tablet, although a single camera measures its
  /// depth inaccurately. A pointing hand is moved along the ray from the camera at `eye` (m, room) through
  /// its index fingertip. A hand in front of the tablet that doesn't point is kept off it. Other hands are
  /// returned unchanged.
  HandPose follow(std::size_t hand, const HandPose& seen, const Pose& tablet, const Vec3& eye,
                  std::int64_t time_ns);
  /// Notes that this hand is not detected: the control that its finger presses is released.
  void lose(std::size_t hand) { fingers_[hand] = {}; }

  static constexpr double dwell = 0.5;  // s that a finger must stay at a control to press it

 private:
  /// State of an index finger in front of the tablet's board: the control under it and whether it presses
  /// that.
  struct Finger {
    std::optional<PanelControl> control;  // control under the finger
    std::int64_t since_ns = 0;
    Vec3 first = Vec3::Zero();  // m, board frame: point at which it came to rest
    bool presses = false;
  };
  void aim(Finger& finger, const Vec3& at, std::int64_t time_ns);

  std::array<Finger, 2> fingers_;
};

}  // namespace prosector
