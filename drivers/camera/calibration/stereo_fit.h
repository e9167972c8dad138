#pragma once
// Pose of a second camera in the first camera's frame, from views of one board that both cameras see.
//
// Each pair of views gives one pose, first_board · second_board⁻¹. Its covariance follows from the
// covariances of both board poses. The result is the mean over all pairs (mean_pose).

#include "drivers/camera/calibration/lens_fit.h"
#include "drivers/camera/calibration/mean_pose.h"

namespace prosector {

inline constexpr std::size_t min_stereo_pairs = 5;
inline constexpr std::size_t recommended_stereo_pairs = 10;

/// Images of one board pose taken by the first and by the second camera, with the tags detected in them.
struct StereoPair {
  LensView first, second;
};

struct StereoFit {
  MeanPose first_second;  // the second camera's pose in the first camera's frame, both frames as in OpenCV
  double held_out = 0;    // pixels RMS in the second camera, over every fifth, unfitted pair
  double expected_error = 0;  // m RMS: expected error at the centre of the boards
};

/// Fits the second camera's pose in the first camera's frame to pairs of views of one board. `first` and
/// `second` are the calibrations of the cameras. Throws InputError with advice if there are too few pairs or
/// they disagree.
StereoFit fit_stereo(const Board& board, std::span<const StereoPair> pairs, const CameraCalibration& first,
                     const CameraCalibration& second);

}  // namespace prosector
