#include "drivers/trackers/vrpn_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/error.h"
#include "drivers/device/station_sample.h"
#include "drivers/ports/stream_port.h"

namespace prosector {
namespace {

constexpr std::int64_t ping_ns = 1'000'000'000;
constexpr std::int32_t own_sender = 0, own_ping = 0;  // numbers announced to the server
constexpr double most_channel = 1e6;
constexpr double no_least_span = 0;  // channels are scaled with configured values only

}  // namespace

VrpnDevice::VrpnDevice(std::string name, std::unique_ptr<DevicePort> port, const Placement& placement,
                       const GestureThresholds& gestures, const GloveConfig& glove)
    : StreamDevice(std::move(port)),
      name_(std::move(name)),
      stations_(placement.stations),
      is_calibrated_(glove.calibration.has_value()),
      chain_(placement),
      hand_(gestures, glove, no_least_span) {}

void VrpnDevice::started(std::int64_t now_ns) {
  reader_ = {};
  last_ping_ns_ = now_ns;
  buttons_ = 0;
  channels_ = {};
  vrpn::Bytes out = vrpn::cookie();
  vrpn::put(out, vrpn::naming(vrpn::names_sender, own_sender, name_));
  vrpn::put(out, vrpn::naming(vrpn::names_type, own_ping, vrpn::ping_type));
  send({reinterpret_cast<const char*>(out.data()), out.size()});
}

/// Sends a ping during silence, so that a server that disappeared without closing the connection is detected.
void VrpnDevice::advance(std::int64_t now_ns) {
  if (!reader_.greeted() || health().quiet_ns(now_ns) < ping_ns || now_ns - last_ping_ns_ < ping_ns) return;
  last_ping_ns_ = now_ns;
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
  if (reader_.broken()) refuse("the server does not use VRPN version 07, or sends damaged data");
}

bool VrpnDevice::take(const vrpn::Message& message, std::vector<DeviceSample>& out) {
  const std::string& type = reader_.type(message);
  if (type == vrpn::pose_type) return take_pose(message, out);
  if (type == vrpn::button_type) {
    const auto button = vrpn::button_of(message.body);
    if (!button || button->number < 0 || button->number >= max_sample_buttons) return false;
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
  return true;  // velocities and other types are ignored
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
  if ((stations_ >> station & 1u) != 0) out.push_back(*sample);
  return true;
}

/// Converts channels to flexions if the configuration provides a calibration.
bool VrpnDevice::take_bends(std::int64_t time_ns, std::vector<DeviceSample>& out) {
  if (!is_calibrated_) return true;
  out.push_back(hand_.sample(channels_, time_ns));
  out.back().buttons = buttons_;
  return true;
}

std::string VrpnDevice::silent_hint() const {
  return reader_.greeted()
             ? fmt::format("the server is connected, but sends no data of '{}': check the name", name_)
             : "no VRPN greeting received: check that the address is that of a VRPN server";
}

std::string VrpnDevice::babble_hint() const {
  return fmt::format("the VRPN device '{}' reports no valid poses, buttons or channels", name_);
}

std::string VrpnDevice::absent_hint() const {
  return "check that the VRPN server runs and that its TCP port can be reached";
}

std::unique_ptr<Device> open_vrpn_device(const std::string& path, const Placement& placement,
                                         const GestureThresholds& gestures, const GloveConfig& glove) {
  const auto there = vrpn::parse_device_location(path);
  if (!there)
    throw InputError(
        fmt::format("device 'vrpn:{}': must be vrpn:NAME@HOST[:PORT], as in vrpn:Tracker0@lab", path));
  const HostPort at = there->at;
  auto port = std::make_unique<StreamPort>(fmt::format("{}@{}:{}", there->name, at.host, at.port),
                                           [at] { return connect_tcp(at.host, at.port); });
  return std::make_unique<VrpnDevice>(there->name, std::move(port), placement, gestures, glove);
}

}  // namespace prosector
