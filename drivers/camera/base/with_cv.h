#pragma once
// Conversions to and from OpenCV's types. Only .cpp files of this folder include it; no other header includes
// OpenCV.

#include <opencv2/core.hpp>

#include "common/math.h"
#include "drivers/camera/base/grey_image.h"

namespace prosector {

/// Converts OpenCV's rotation vector `turn` (rad) and translation `place` (m) to a pose.
inline Pose pose_of(const cv::Mat& turn, const cv::Mat& place) {
  const Vec3 r(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  Pose pose;
  pose.p = {place.at<double>(0), place.at<double>(1), place.at<double>(2)};
  const double angle = r.norm();
  if (angle > 0) pose.q = Quat(Eigen::AngleAxisd(angle, r / angle));
  return pose;
}

/// Returns an OpenCV matrix that refers to the image's pixels without a copy. Callers must only read it.
inline cv::Mat matrix_of(const GreyImage& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.grey.data())};
}

}  // namespace prosector
