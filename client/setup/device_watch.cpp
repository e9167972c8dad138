#include "client/setup/device_watch.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "common/error.h"
#include "drivers/device/driver_table.h"

namespace prosector {
namespace {

constexpr std::int64_t window_ns = 2'000'000'000;
// Samples per station, which limits memory if a device sends too many.
constexpr std::size_t most_kept = 4096;

/// Returns the statistics of one station's samples.
WatchedStation look_at(const std::deque<DeviceSample>& samples) {
  WatchedStation out;
  out.last = samples.back();
  const double seconds = 1e-9 * static_cast<double>(samples.back().time_ns - samples.front().time_ns);
  const std::size_t gaps = samples.size() - 1;
  if (gaps > 0 && seconds > 0) {
    out.rate = static_cast<double>(gaps) / seconds;
    double squares = 0;
    for (std::size_t k = 1; k < samples.size(); ++k)
      squares +=
          std::pow(1e-9 * static_cast<double>(samples[k].time_ns - samples[k - 1].time_ns) - 1 / out.rate, 2);
    out.jitter = std::sqrt(squares / static_cast<double>(gaps));
  }
  if (out.last.has_pose) {
    Eigen::AlignedBox3d box;
    for (const DeviceSample& s : samples)
      if (s.has_pose && s.pose.p.allFinite()) box.extend(s.pose.p);
    if (!box.isEmpty()) out.moved = box.diagonal().norm();
  }
  return out;
}

/// Requests all receivers of a tracker, including those without a role.
DeviceConfig all_receivers(DeviceConfig device) {
  device.placement.stations = (1u << max_stations) - 1;
  return device;
}

}  // namespace

struct DeviceWatch::Opened {
  std::unique_ptr<Device> device;  // or …
  std::unique_ptr<Arm> arm;
  std::string refusal;  // reason why neither could be opened
  std::map<std::uint32_t, std::deque<DeviceSample>> kept;
  std::vector<DeviceSample> fresh;

  void read(std::int64_t now_ns) {
    fresh.clear();
    if (device) device->poll(fresh);
    if (!arm) return;
    const ArmReading reading = arm->read();
    if (!reading.valid) return;
    DeviceSample& sample = fresh.emplace_back();
    sample.time_ns = now_ns;
    sample.has_pose = true;
    sample.pose = reading.stylus;
    sample.buttons = reading.buttons;
  }
  DeviceStatus status() const {
    if (device) return device->status();
    if (arm) return arm->status();
    DeviceStatus out;
    out.health = DeviceHealth::absent;
    out.message = refusal;
    return out;
  }
};

DeviceWatch::DeviceWatch(const ClientConfig& config) {
  const auto open = [&](WatchedKind kind, std::size_t hand, const char* name, const std::string& address,
                        const auto& opening) {
    if (address.empty()) return;
    auto opened = std::make_unique<Opened>();
    try {
      opening(*opened);
    } catch (const InputError& error) {
      opened->refusal = error.what();
    }
    add({kind, hand, name, address, {}, {}}, std::move(opened));
  };
  open(WatchedKind::tracker, right_hand, msg("tracker"), config.tracker,
       [&](Opened& o) { o.device = open_device(config.tracker, all_receivers(config.tracker_device)); });
  for (const std::size_t hand : {right_hand, left_hand}) {
    const GloveSettings& glove = config.gloves[hand];
    open(WatchedKind::glove, hand, hand == right_hand ? msg("right glove") : msg("left glove"), glove.address,
         [&](Opened& o) { o.device = open_device(glove.address, glove.device); });
  }
  open(WatchedKind::arm, config.arm.hand, msg("arm"), config.arm.address,
       [&](Opened& o) { o.arm = open_arm(config.arm.address, config.arm.arm); });
}

DeviceWatch::~DeviceWatch() = default;

void DeviceWatch::add(WatchedDevice device, std::unique_ptr<Opened> opened) {
  devices_.push_back(std::move(device));
  opened_.push_back(std::move(opened));
}

void DeviceWatch::poll(std::int64_t now_ns) {
  for (std::size_t k = 0; k < opened_.size(); ++k) {
    Opened& o = *opened_[k];
    o.read(now_ns);
    for (DeviceSample& sample : o.fresh) o.kept[sample.station].push_back(sample);
    WatchedDevice& device = devices_[k];
    device.status = o.status();
    device.stations.clear();
    for (auto& [station, samples] : o.kept) {
      while (!samples.empty() && (samples.front().time_ns < now_ns - window_ns || samples.size() > most_kept))
        samples.pop_front();
      if (!samples.empty()) device.stations.push_back(look_at(samples));
    }
  }
}

std::optional<std::uint32_t> moving_station(const WatchedDevice& tracker) {
  const WatchedStation* most = nullptr;
  double second = 0;
  for (const WatchedStation& station : tracker.stations) {
    if (most == nullptr || station.moved > most->moved) {
      if (most != nullptr) second = most->moved;
      most = &station;
    } else {
      second = std::max(second, station.moved);
    }
  }
  if (most == nullptr || most->moved < min_moved_distance || most->moved < least_share * second)
    return std::nullopt;
  return most->last.station;
}

}  // namespace prosector
