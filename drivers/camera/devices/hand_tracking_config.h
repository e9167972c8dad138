#pragma once
// Settings of a tracker of bare hands beyond its first camera.

#include <optional>
#include <string>

#include "common/math.h"
#include "drivers/camera/nets/hand_nets.h"

namespace prosector {

struct HandTrackingConfig {
  std::string second_lens;              // calibration file of a second camera; empty: parameters are guessed
  Pose first_second;                    // pose of the second camera in the frame of the first
  std::optional<double> hand_length;    // m, wrist to middle fingertip; nothing: that of the hand model
  HandNets hand_nets = HandNets::full;  // which networks detect the hands
  double farthest_hand = default_hand_range;  // m; farther hands are ignored as bystanders'
};

}  // namespace prosector
