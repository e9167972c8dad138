#include "drivers/station_sample.h"

#include <cmath>

namespace prosector {
namespace {

constexpr double farthest = 100;   // m
constexpr double off_unit = 0.05;  // by which a quaternion's length may be off: some senders round

}  // namespace

std::array<float, 7> raw_pose_of(const Pose& device) {
  const Eigen::Vector3f p = device.p.cast<float>();
  const Eigen::Quaternionf q = device.q.cast<float>();
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn) {
  if (station >= max_stations || !place.allFinite() || place.norm() > farthest ||
      !(std::abs(turn.norm() - 1) < off_unit))
    return std::nullopt;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station);
  out.has_pose = true;
  out.pose = chain.room({place, turn.normalized()}, station);
  out.raw_pose = raw_pose_of({place, turn});
  return out;
}

}  // namespace prosector
