#pragma once
// OpenCV's rotation vector and shift as a pose, and back. For .cpp files of this folder: OpenCV is in none of
// its other headers.

#include <opencv2/core.hpp>

#include "common/math.h"

namespace prosector {

inline Pose pose_of(const cv::Mat& turn, const cv::Mat& place) {
  const Vec3 r(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  Pose pose;
  pose.p = {place.at<double>(0), place.at<double>(1), place.at<double>(2)};
  const double angle = r.norm();
  if (angle > 0) pose.q = Quat(Eigen::AngleAxisd(angle, r / angle));
  return pose;
}

}  // namespace prosector
