#pragma once
// Who wears a simulated headset: a script's stations 1, 2 and 3 are head, left and right hand.

#include "common/hand.h"
#include "drivers/motion_script.h"

namespace prosector {

inline constexpr std::size_t worn_joints = 26;  // of a hand, in the order of XrHandJointEXT

/// Returns the joints that a headset sees of our hand, in the wrist's frame.
std::array<Pose, worn_joints> seen_joints(std::size_t hand, const std::array<double, fingers>& flexion);

class HeadsetWearer {
 public:
  explicit HeadsetWearer(MotionScript script) : script_(std::move(script)) {}

  Pose head(double time) const { return script_.pose(0, time, false); }
  Pose wrist(std::size_t hand, double time) const { return script_.pose(1 + hand, time, false); }
  std::array<double, fingers> flexion(std::size_t hand, double time) const {
    return script_.flexion(1 + hand, time, false);
  }
  /// Returns the grip of a controller that the hand holds, as OpenXR defines it.
  Pose grip(std::size_t hand, double time) const;

 private:
  MotionScript script_;
};

}  // namespace prosector
