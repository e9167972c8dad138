#pragma once
// Where a second camera stands in the first one's frame, from boards that both see at the same time.
//
// Each view gives one pose, first_board · second_board⁻¹; its spread comes from both boards' spreads. What is
// told is the mean over all views (mean_pose).

#include "drivers/camera/calibration/mean_pose.h"

namespace prosector {

inline constexpr std::size_t least_stereo_views = 4;
inline constexpr std::size_t usual_stereo_views = 10;

/// A board as both cameras see it, in OpenCV's camera frames.
struct StereoView {
  MeasuredPose first_board, second_board;
};

/// Fits the second camera in the first one's frame, both as OpenCV has them. Throws InputError that says what
/// to do where there are too few views, or they disagree.
MeanPose fit_stereo(std::span<const StereoView> views);

}  // namespace prosector
