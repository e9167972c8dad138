#pragma once
// What a glove's counts mean, from poses that the hand held.
//
// Each sensor's open and closed counts are the medians of its counts in the flat hand and in the fist. A
// joint bends by 90° over that span (common/hand.h), so counts are degrees by 90°/span. The error that is
// expected of a joint adds up noise of a reading, the quantum of a count, and how differently the same finger
// was bent in two poses:
//   e² = (90°/span)² (noise² + 1/12) + (90°·repeat)²

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/messages.h"
#include "drivers/device.h"

namespace prosector {

using GloveCounts = std::array<double, fingers>;

/// A pose that is asked for: which fingers are bent.
struct GlovePose {
  const char* name;
  const char* instruction;
  std::array<bool, fingers> bent;
};
/// Returns flat, fist, then each finger bent alone, thumb first.
std::span<const GlovePose> glove_poses();

/// What a sensor told while a pose was held.
struct HeldCounts {
  GloveCounts median{};
  GloveCounts noise{};  // RMS, by the median distance from the median
};
HeldCounts hold_counts(std::span<const std::array<std::uint16_t, fingers>> readings);

struct GloveFit {
  GloveCalibration calibration;
  bool falls_on_bending = false;    // of most sensors
  GloveCounts span{};               // counts
  GloveCounts repeat{};             // flexion: the finger alone against the fist
  GloveCounts joint_error{};        // rad RMS, expected of MCP and PIP
  std::vector<std::string> doubts;  // in words: what to look at
};

/// Fits to what was held in the order of glove_poses(); all of them, or flat and fist alone. Throws
/// InputError that names the finger whose span is below `least_span` counts.
GloveFit fit_glove(std::span<const HeldCounts> held, double least_span);

}  // namespace prosector
