#include "drivers/camera/calibration/mean_pose.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int mean_rounds = 12;
constexpr double mean_huber = 3;            // Mahalanobis distance, over six components
constexpr double most_deviations = 5;       // Mahalanobis distance; poses beyond it are left out
constexpr double median_deviations = 2.31;  // median norm of six standard normal numbers

/// A pose with the inverse of its covariance.
struct Weighed {
  std::size_t index;
  Pose pose;
  MotionCovariance inverse;
};

double deviations(const Weighed& one, const Pose& from) {
  const SmallMotion off = motion_between(from, one.pose);
  return std::sqrt(std::max(0.0, off.dot(one.inverse * off)));
}

double median_distance(std::span<const Weighed> poses, const Pose& from) {
  std::vector<double> all;
  for (const Weighed& one : poses) all.push_back(deviations(one, from));
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

/// Returns the pose with the least median Mahalanobis distance of the poses from it.
Pose most_central_pose(std::span<const Weighed> poses) {
  const auto nearer = [&](const Weighed& a, const Weighed& b) {
    return median_distance(poses, a.pose) < median_distance(poses, b.pose);
  };
  return std::min_element(poses.begin(), poses.end(), nearer)->pose;
}

/// Refines the mean by iteratively reweighted least squares. Returns the sum of the weighted inverse
/// covariances.
MotionCovariance improve(std::span<const Weighed> poses, double scale, Pose& mean) {
  MotionCovariance sum = MotionCovariance::Zero();
  for (int round = 0; round < mean_rounds; ++round) {
    sum.setZero();
    SmallMotion right = SmallMotion::Zero();
    for (const Weighed& one : poses) {
      const double far = deviations(one, mean) / scale;
      const double weight = far > mean_huber ? mean_huber / far : 1;
      sum += weight * one.inverse;
      right += weight * one.inverse * motion_between(mean, one.pose);
    }
    mean = moved(mean, sum.ldlt().solve(right));
  }
  return sum;
}

}  // namespace

MeanPose mean_pose(std::span<const MeasuredPose> poses) {
  if (poses.empty()) throw InputError("no pose was measured");
  std::vector<Weighed> kept;
  for (std::size_t i = 0; i < poses.size(); ++i)
    kept.push_back({i, poses[i].pose, poses[i].spread.ldlt().solve(MotionCovariance::Identity())});
  MeanPose out;
  out.pose = most_central_pose(kept);
  double scale = std::max(1.0, median_distance(kept, out.pose) / median_deviations);
  (void)improve(kept, scale, out.pose);
  scale = std::max(1.0, median_distance(kept, out.pose) / median_deviations);
  std::erase_if(kept, [&](const Weighed& one) {
    if (deviations(one, out.pose) <= most_deviations * scale) return false;
    out.left_out.push_back(one.index);
    return true;
  });
  if (2 * kept.size() < poses.size())
    throw InputError(fmt::format(
        "only {} of {} measured poses agree, less than half: take the poses again, and hold still",
        kept.size(), poses.size()));
  const MotionCovariance sum = improve(kept, scale, out.pose);
  double squares = 0;
  for (const Weighed& one : kept) squares += std::pow(deviations(one, out.pose), 2);
  const double freedom = 6.0 * static_cast<double>(kept.size()) - 6;
  const double more = freedom > 0 ? std::max(1.0, squares / freedom) : 1;
  out.spread = more * sum.ldlt().solve(MotionCovariance::Identity());
  return out;
}

}  // namespace prosector
