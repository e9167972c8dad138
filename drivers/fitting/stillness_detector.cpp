#include "drivers/fitting/stillness_detector.h"

#include <algorithm>

namespace prosector {

void StillnessDetector::take(std::int64_t time_ns, const Pose& pose) {
  constexpr std::int64_t longest_gap_ns = 200'000'000;
  if (!readings_.empty() && time_ns - readings_.back().time_ns > longest_gap_ns) readings_.clear();
  readings_.push_back({time_ns, pose});
  const auto span_ns = static_cast<std::int64_t>(1e9 * limits_.seconds);
  while (readings_.size() > limits_.least && time_ns - readings_[1].time_ns >= span_ns) readings_.pop_front();
  still_ = false;
  if (filled() < 1) return;
  const std::size_t half = readings_.size() / 2;
  const Pose a = mean_of(0, half), b = mean_of(half, readings_.size());
  const PoseErrors apart = {(a.p - b.p).norm(), a.q.angularDistance(b.q)};
  mean_error_ = {apart.position / 2, apart.turn / 2};
  still_ = apart.position < limits_.motion && apart.turn < limits_.turn;
}

double StillnessDetector::filled() const {
  if (readings_.empty()) return 0;
  const auto span = 1e-9 * static_cast<double>(readings_.back().time_ns - readings_.front().time_ns);
  const double count = static_cast<double>(readings_.size()) / static_cast<double>(limits_.least);
  return std::min({1.0, span / limits_.seconds, count});
}

Pose StillnessDetector::mean() const {
  return readings_.empty() ? Pose() : mean_of(0, readings_.size());
}

Pose StillnessDetector::mean_of(std::size_t first, std::size_t end) const {
  Pose out;
  Eigen::Vector4d turn = Eigen::Vector4d::Zero();
  const Eigen::Vector4d reference = readings_[first].pose.q.coeffs();
  for (std::size_t i = first; i < end; ++i) {
    out.p += readings_[i].pose.p / static_cast<double>(end - first);
    const Eigen::Vector4d q = readings_[i].pose.q.coeffs();
    turn += q.dot(reference) < 0 ? Eigen::Vector4d(-q) : q;
  }
  out.q.coeffs() = turn.normalized();
  return out;
}

}  // namespace prosector
