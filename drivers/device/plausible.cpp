#include "drivers/device/plausible.h"

#include <algorithm>
#include <cmath>

namespace prosector {
namespace {

constexpr double rotation_tolerance = 1e-3;  // of the inner products of a matrix's columns
constexpr double room_reach = 10'000;        // m: device range, plus the device's position in the room

}  // namespace

bool is_within(const Vec3& position, double reach) {
  return position.allFinite() && position.norm() <= reach;
}

bool is_unit(const Quat& q, double tolerance) {
  return std::abs(q.norm() - 1) < tolerance;
}

bool is_unit(const Vec3& direction, double tolerance) {
  return std::abs(direction.norm() - 1) < tolerance;
}

bool is_rotation(const Mat3& matrix) {
  return matrix.allFinite() && (matrix.transpose() * matrix).isIdentity(rotation_tolerance) &&
         matrix.determinant() > 0;
}

std::optional<Pose> plausible_pose(const Vec3& position, const Quat& rotation, double reach) {
  if (!is_within(position, reach) || !is_unit(rotation)) return std::nullopt;
  return Pose{position, rotation.normalized()};
}

std::optional<Pose> plausible_pose(const Vec3& position, const Mat3& rotation, double reach) {
  if (!is_within(position, reach) || !is_rotation(rotation)) return std::nullopt;
  return Pose{position, Quat(rotation).normalized()};
}

bool is_plausible(const DeviceSample& sample) {
  const auto finite = [](float x) { return std::isfinite(x); };
  const auto bend = [](double x) { return x >= 0 && x <= 1; };
  if (sample.has_pose && !(is_within(sample.pose.p, room_reach) && is_unit(sample.pose.q) &&
                           std::ranges::all_of(sample.raw_pose, finite)))
    return false;
  return !sample.has_flexion || std::ranges::all_of(sample.flexion, bend);
}

std::size_t remove_implausible(std::vector<DeviceSample>& samples, std::size_t first) {
  const auto begin = samples.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = std::remove_if(begin, samples.end(), [](const auto& s) { return !is_plausible(s); });
  const auto dropped = static_cast<std::size_t>(samples.end() - end);
  samples.erase(end, samples.end());
  return dropped;
}

Vec3 bounded_force(const Vec3& force, double most) {
  if (!force.allFinite()) return Vec3::Zero();
  const double size = force.stableNorm();
  return size > most ? Vec3(force * (most / size)) : force;
}

}  // namespace prosector
