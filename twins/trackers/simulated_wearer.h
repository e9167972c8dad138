#pragma once
// Wearer of a simulated headset: stations 1, 2 and 3 of a script are the head, the left and the right hand.

#include "common/hand.h"
#include "drivers/recordings/motion_script.h"

namespace prosector {

inline constexpr std::size_t joints_per_hand = 26;  // joints per hand, in the order of XrHandJointEXT

/// Returns the 26 joint poses that OpenXR defines for a hand, for the hand model at these flexions (0 open …
/// 1 closed). They are in the wrist's frame, m.
std::array<Pose, joints_per_hand> hand_model_joints(std::size_t hand,
                                                    const std::array<double, fingers>& flexion);

class SimulatedWearer {
 public:
  explicit SimulatedWearer(MotionScript script) : script_(std::move(script)) {}

  Pose head(double time) const { return script_.pose(0, time, false); }
  Pose wrist(std::size_t hand, double time) const { return script_.pose(1 + hand, time, false); }
  std::array<double, fingers> flexion(std::size_t hand, double time) const {
    return script_.flexion(1 + hand, time, false);
  }
  /// Returns the pose that OpenXR's grip space has for a controller in the wearer's hand at `time`, s; room
  /// frame.
  Pose grip(std::size_t hand, double time) const;

 private:
  MotionScript script_;
};

}  // namespace prosector
