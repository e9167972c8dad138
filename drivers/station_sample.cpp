#include "drivers/station_sample.h"

#include <cmath>

namespace prosector {
namespace {

constexpr double farthest = 100;   // m
constexpr double off_unit = 0.05;  // by which a quaternion's length may be off: some senders round

}  // namespace

std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn) {
  if (station >= max_stations || !place.allFinite() || place.norm() > farthest ||
      !(std::abs(turn.norm() - 1) < off_unit))
    return std::nullopt;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station);
  out.has_pose = true;
  out.pose = chain.room({place, turn.normalized()}, station);
  for (std::size_t i = 0; i < 3; ++i) out.raw_pose[i] = static_cast<float>(place[static_cast<int>(i)]);
  const std::array<double, 4> q = {turn.w(), turn.x(), turn.y(), turn.z()};
  for (std::size_t i = 0; i < 4; ++i) out.raw_pose[3 + i] = static_cast<float>(q[i]);
  return out;
}

}  // namespace prosector
