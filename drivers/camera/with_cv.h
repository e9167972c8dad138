#pragma once
// OpenCV's types as ours, and ours as OpenCV's. For .cpp files of this folder: OpenCV is in none of its other
// headers.

#include <opencv2/core.hpp>

#include "common/math.h"
#include "drivers/camera/grey_image.h"

namespace prosector {

/// Makes a pose of a rotation vector and a shift.
inline Pose pose_of(const cv::Mat& turn, const cv::Mat& place) {
  const Vec3 r(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  Pose pose;
  pose.p = {place.at<double>(0), place.at<double>(1), place.at<double>(2)};
  const double angle = r.norm();
  if (angle > 0) pose.q = Quat(Eigen::AngleAxisd(angle, r / angle));
  return pose;
}

/// Returns a picture as OpenCV's, for reading alone: it shares the bytes.
inline cv::Mat matrix_of(const GreyImage& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.grey.data())};
}

}  // namespace prosector
