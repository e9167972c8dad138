#include "drivers/device/station_sample.h"

#include "drivers/device/plausible.h"

namespace prosector {

std::array<float, 7> raw_pose_of(const Pose& device) {
  const Eigen::Vector3f p = device.p.cast<float>();
  const Eigen::Quaternionf q = device.q.cast<float>();
  return {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()};
}

std::optional<DeviceSample> station_sample(const PoseChain& chain, std::size_t station, const Vec3& place,
                                           const Quat& turn) {
  const auto pose = plausible_pose(place, turn, tracker_reach);
  if (station >= max_stations || !pose) return std::nullopt;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station);
  out.has_pose = true;
  out.pose = chain.room(*pose, station);
  out.raw_pose = raw_pose_of({place, turn});
  return out;
}

}  // namespace prosector
