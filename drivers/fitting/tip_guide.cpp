#include "drivers/fitting/tip_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace prosector {
namespace {

constexpr std::size_t required_poses = 200;
constexpr double min_pose_rotation = 0.01;  // rad; a pose with less rotation adds no information

}  // namespace

TipGuide::TipGuide(const ClientConfig& config, StationRole role)
    : role_(role), station_(station_of_role(config, role)) {}

DeviceConfig TipGuide::device(const ClientConfig& config, StationRole role) {
  DeviceConfig out = config.tracker_device;
  out.placement.room_device = {};
  out.placement.mount[station_of_role(config, role)] = {};
  return out;
}

void TipGuide::take(const DeviceSample& sample) {
  if (sample.station != station_ || !sample.has_trusted_pose() || poses_.size() == required_poses) return;
  if (!rests_) {
    window_.take(sample.time_ns, sample.pose);
    rests_ = window_.still();
    if (!rests_) return;
  }
  if (poses_.empty() || poses_.back().q.angularDistance(sample.pose.q) >= min_pose_rotation)
    poses_.push_back(sample.pose);
}

GuideStep TipGuide::step() const {
  GuideStep out;
  out.count = 2;
  out.index = poses_.size() == required_poses ? 2 : rests_ ? 1 : 0;
  out.done = out.index == out.count;
  if (out.index == 0) {
    out.instruction = "Put the tip into a dimple so that it cannot slip, and hold still";
    out.progress = window_.filled();
  } else if (out.index == 1) {
    out.instruction =
        "Swing the instrument about its tip, in a cone of ±30° in all directions, without lifting the tip";
    out.progress = static_cast<double>(poses_.size()) / required_poses;
  }
  return out;
}

void TipGuide::back() {
  rests_ = false;
  window_.clear();
  poses_.clear();
}

GuideOutcome TipGuide::outcome() const {
  const PivotFit f = fit();
  const std::string station = fmt::format("tracker.stations.{}.", role_name(role_));
  constexpr double degrees = 180 / std::numbers::pi;
  GuideOutcome out;
  out.words.push_back(
      fmt::format("tip at {:.2f}, {:.2f}, {:.2f} mm in the receiver's frame, distance {:.1f} mm",
                  1e3 * f.tip.x(), 1e3 * f.tip.y(), 1e3 * f.tip.z(), 1e3 * f.tip.norm()));
  out.words.push_back(
      fmt::format("{} poses of the instrument, rotated by at least {:.0f}° RMS; residual error {:.2f} mm "
                  "RMS; expected error of the tip {:.2f} mm RMS",
                  f.poses, degrees * f.turn, 1e3 * f.residual, 1e3 * f.tip_error));
  out.changes = {{station + "station", static_cast<double>(station_ + 1)},
                 {station + "mount.position", written(f.tip)}};
  return out;
}

}  // namespace prosector
