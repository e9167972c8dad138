#include "drivers/vrpn_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/error.h"
#include "drivers/line_port.h"
#include "drivers/station_sample.h"

namespace prosector {
namespace {

constexpr std::int64_t ping_ns = 1'000'000'000;
constexpr std::int32_t own_sender = 0, own_ping = 0;  // as they are named to the server
constexpr double most_channel = 1e6;
constexpr double no_least_span = 0;  // channels bend by configured values alone

}  // namespace

VrpnDevice::VrpnDevice(std::string name, std::unique_ptr<DevicePort> port, const DeviceConfig& config)
    : StreamDevice(std::move(port)),
      name_(std::move(name)),
      config_(config),
      chain_(config),
      hand_(config, no_least_span) {}

void VrpnDevice::started(std::int64_t now_ns) {
  reader_ = {};
  pinged_ns_ = now_ns;
  buttons_ = 0;
  channels_ = {};
  vrpn::Bytes out = vrpn::cookie();
  vrpn::put(out, vrpn::naming(vrpn::names_sender, own_sender, name_));
  vrpn::put(out, vrpn::naming(vrpn::names_type, own_ping, vrpn::ping_type));
  send({reinterpret_cast<const char*>(out.data()), out.size()});
}

/// Pings while nothing comes, so that a server that is gone without a word is noticed.
void VrpnDevice::advance(std::int64_t now_ns) {
  if (!reader_.greeted() || health().quiet_ns(now_ns) < ping_ns || now_ns - pinged_ns_ < ping_ns) return;
  pinged_ns_ = now_ns;
  vrpn::Bytes out;
  vrpn::put(out, {own_sender, own_ping, {}});
  send({reinterpret_cast<const char*>(out.data()), out.size()});
}

void VrpnDevice::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  reader_.take(buffer().bytes(), buffer().time_ns());
  buffer().clear();
  while (const auto message = reader_.next()) {
    if (message->type < 0 || reader_.sender(*message) != name_) continue;
    const std::string& type = reader_.type(*message);
    if (type == vrpn::ping_type || type == vrpn::pong_type) continue;
    if (take(*message, out))
      health().record(now_ns, message->body.size());
    else
      health().garbage(now_ns, message->body.size());
  }
  if (reader_.broken()) refuse("what answers does not speak VRPN of version 07, or spoils it");
}

bool VrpnDevice::take(const vrpn::Message& message, std::vector<DeviceSample>& out) {
  const std::string& type = reader_.type(message);
  if (type == vrpn::pose_type) return take_pose(message, out);
  if (type == vrpn::button_type) {
    const auto button = vrpn::button_of(message.body);
    if (!button || button->number < 0 || button->number >= buttons_told) return false;
    const std::uint32_t bit = 1u << button->number;
    buttons_ = button->pressed ? buttons_ | bit : buttons_ & ~bit;
  } else if (type == vrpn::analog_type) {
    const auto channels = vrpn::channels_of(message.body);
    if (!channels || !std::ranges::all_of(*channels, [](double x) { return std::abs(x) < most_channel; }))
      return false;
    std::copy_n(channels->begin(), std::min(fingers, channels->size()), channels_.begin());
    return take_bends(message.time_ns, out);
  } else if (type == vrpn::dial_type) {
    const auto dial = vrpn::dial_of(message.body);
    if (!dial || dial->number < 0 || !(std::abs(dial->turned) < most_channel)) return false;
    if (static_cast<std::size_t>(dial->number) >= fingers) return true;
    double& channel = channels_[static_cast<std::size_t>(dial->number)];
    channel = std::clamp(channel + dial->turned, -most_channel, most_channel);
    return take_bends(message.time_ns, out);
  }
  return true;  // velocities and others
}

bool VrpnDevice::take_pose(const vrpn::Message& message, std::vector<DeviceSample>& out) {
  const auto said = vrpn::tracker_pose_of(message.body);
  if (!said || said->sensor < 0) return false;
  const auto station = static_cast<std::size_t>(said->sensor);
  if (station >= max_stations) return true;
  auto sample = station_sample(chain_, station, said->place, said->turn);
  if (!sample) return false;
  sample->record = records_[station]++;
  sample->time_ns = message.time_ns;
  sample->buttons = buttons_;
  if ((config_.stations >> station & 1u) != 0) out.push_back(*sample);
  return true;
}

/// Makes bends of channels, where the configuration says from which values to which.
bool VrpnDevice::take_bends(std::int64_t time_ns, std::vector<DeviceSample>& out) {
  if (!config_.calibration) return true;
  out.push_back(hand_.sample(channels_, time_ns));
  out.back().buttons = buttons_;
  return true;
}

std::string VrpnDevice::silent_hint() const {
  return reader_.greeted()
             ? fmt::format("the server is there, but nothing of '{}' comes: is that its name there?", name_)
             : "nothing greets there: is it a VRPN server?";
}

std::string VrpnDevice::babble_hint() const {
  return fmt::format("what '{}' reports are no poses, buttons or channels", name_);
}

std::string VrpnDevice::absent_hint() const {
  return "check that the VRPN server runs and that its TCP port can be reached";
}

std::unique_ptr<Device> open_vrpn_device(const std::string& path, const DeviceConfig& config) {
  const auto there = vrpn::parse_place(path);
  if (!there)
    throw InputError(
        fmt::format("device 'vrpn:{}': must be vrpn:NAME@HOST[:PORT], as in vrpn:Tracker0@lab", path));
  const HostPort at = there->at;
  auto port = std::make_unique<LinePort>(fmt::format("{}@{}:{}", there->name, at.host, at.port),
                                         [at] { return connect_tcp(at.host, at.port); });
  return std::make_unique<VrpnDevice>(there->name, std::move(port), config);
}

}  // namespace prosector
