#pragma once
// Calibration of a glove's sensor counts from held hand poses.
//
// The open and closed counts of a sensor are the medians of its counts with the flat hand and with the fist.
// A joint bends by 90° over that span (common/hand.h), so one count is 90°/span. The expected error of a
// joint combines the noise of a reading, the quantisation of a count, and the repeatability of a finger's
// bend between two poses:
//   e² = (90°/span)² (noise² + 1/12) + (90°·repeat)²

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/hand_pose.h"
#include "drivers/gloves/glove_config.h"

namespace prosector {

using GloveCounts = std::array<double, fingers>;

/// A pose that the user is asked to hold, and which fingers it bends.
struct GlovePose {
  const char* name;
  const char* instruction;
  std::array<bool, fingers> bent;
};
/// Returns the poses: flat hand, fist, then each finger bent alone, thumb first.
std::span<const GlovePose> glove_poses();

/// Sensor counts while a pose was held.
struct PoseCounts {
  GloveCounts median{};
  GloveCounts noise{};  // RMS, estimated by the median absolute deviation
};
PoseCounts pose_counts(std::span<const std::array<std::uint16_t, fingers>> readings);

struct GloveFit {
  GloveCalibration calibration;
  bool falls_on_bending = false;    // true: most sensors' counts fall when a finger bends
  GloveCounts span{};               // counts
  GloveCounts repeat{};             // flexion difference between the finger bent alone and in the fist
  GloveCounts joint_error{};        // rad RMS, expected for the MCP and PIP joints
  std::vector<std::string> doubts;  // messages about suspicious sensors
};

/// Fits the calibration to poses in the order of glove_poses(): all of them, or flat hand and fist only.
/// Throws InputError that names the finger whose span is below `least_span` counts.
GloveFit fit_glove(std::span<const PoseCounts> held, double least_span);

}  // namespace prosector
