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

/// A hand pose that the user is asked to hold during a glove's calibration: its name, the instruction, and
/// the fingers that it bends (thumb first).
struct GlovePose {
  const char* name;
  const char* instruction;
  std::array<bool, fingers> bent;
};
/// Returns the hand poses of a glove's calibration in order: flat hand, fist, then each finger bent alone,
/// thumb first.
std::span<const GlovePose> glove_poses();

/// Median and noise of the counts of each bend sensor of a glove while a hand pose was held.
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

/// Fits a glove's calibration to the sensor counts of held hand poses, in the order of glove_poses(). Needs
/// all poses, or only flat hand and fist. Throws InputError that names the finger whose counts differ by less
/// than `least_span` between flat hand and fist.
GloveFit fit_glove(std::span<const PoseCounts> held, double least_span);

}  // namespace prosector
