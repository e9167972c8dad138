#pragma once
// Where a second camera stands in the first one's frame, from views of one board that both see.
//
// Each pair of views gives one pose, first_board · second_board⁻¹; its spread comes from both boards'
// spreads. What is told is the mean over all pairs (mean_pose).

#include "drivers/camera/calibration/lens_fit.h"
#include "drivers/camera/calibration/mean_pose.h"

namespace prosector {

inline constexpr std::size_t least_stereo_pairs = 5;
inline constexpr std::size_t usual_stereo_pairs = 10;

/// One place of the board, as both cameras see it.
struct StereoPair {
  LensView first, second;
};

struct StereoFit {
  MeanPose first_second;  // the second camera in the first one's frame, both as OpenCV has them
  double held_out = 0;    // pixels RMS: where the second camera sees boards whose pairs weren't fitted
  double told = 0;        // m RMS: expected error of points amid the boards
};

/// Fits. Throws InputError that says what to do where there are too few pairs, or they disagree.
StereoFit fit_stereo(const Board& board, std::span<const StereoPair> pairs, const CameraCalibration& first,
                     const CameraCalibration& second);

}  // namespace prosector
