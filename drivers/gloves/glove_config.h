#pragma once
// Settings of a data glove beyond the thresholds of its gestures.

#include <array>
#include <optional>

#include "common/hand_pose.h"

namespace prosector {

/// Raw sensor counts of a glove with all fingers open and with all fingers closed, thumb first. Without a
/// calibration the driver learns each sensor's range from its samples.
struct GloveCalibration {
  std::array<double, fingers> open{},
      closed{};  // counts; `open` may be larger if counts decrease when a finger bends
};

struct GloveConfig {
  bool left = false;                            // left hand
  bool falls_on_bending = false;                // counts decrease when a finger bends (some USB gloves)
  std::optional<GloveCalibration> calibration;  // fixed counts instead of learned ranges
};

}  // namespace prosector
