#include "drivers/trackers/leap_device.h"

#include <fmt/format.h>

#include <utility>

#include "common/error.h"
#include "drivers/device/plausible.h"
#include "drivers/device/station_sample.h"
#include "drivers/ports/byte_line.h"

namespace prosector {
namespace {

constexpr std::size_t max_queued_texts = 64;  // queued texts; the oldest is dropped first

}  // namespace

LeapDevice::LeapDevice(std::string where, const Placement& placement, const GestureThresholds& gestures)
    : where_(std::move(where)),
      chain_(placement),
      gestures_{GestureDetector(gestures), GestureDetector(gestures)} {}

void LeapDevice::connect_service(const std::string& host, const std::string& port) {
  socket_ = std::make_unique<WebSocket>(host, port, leap::target,
                                        [this](std::string_view text) { return handle_text(text); });
}

std::optional<std::vector<std::string>> LeapDevice::handle_text(std::string_view text) {
  Heard heard{monotonic_ns(), text.size(), leap::read_text(text)};
  const bool greets = heard.text && heard.text->version;
  const bool strange = greets && heard.text->version != leap::known_version;
  std::lock_guard lock(mutex_);
  if (heard_.size() == max_queued_texts) heard_.pop_front();
  heard_.push_back(std::move(heard));
  if (strange) return std::nullopt;
  return greets ? leap::ask_for_frames() : std::vector<std::string>{};
}

void LeapDevice::poll(std::vector<DeviceSample>& out) {
  const std::int64_t now_ns = monotonic_ns();
  if (socket_) line_ = socket_->state();
  if (line_.connections > connections_) health_.opened(now_ns);
  connections_ = line_.connections;
  std::deque<Heard> heard;
  {
    std::lock_guard lock(mutex_);
    heard.swap(heard_);
  }
  for (const Heard& one : heard) take(one, out);
  if (socket_ && !line_.connected) health_.lost();
}

void LeapDevice::take(const Heard& heard, std::vector<DeviceSample>& out) {
  if (!heard.text) return health_.garbage(heard.time_ns, heard.bytes);
  if (heard.text->version) version_ = *heard.text->version;
  if (version_ != leap::known_version) return health_.garbage(heard.time_ns, heard.bytes);
  if (heard.text->streaming) has_camera_ = *heard.text->streaming;
  if (heard.text->version || heard.text->is_event) return;
  has_camera_ = true;
  health_.record(heard.time_ns, heard.bytes);
  const std::size_t before = out.size();
  for (const leap::Hand& hand : heard.text->hands) {
    const std::size_t station = hand.left ? 1 : 0;
    const Pose wrist = leap::wrist_of(hand);
    DeviceSample& sample = out.emplace_back();
    sample.station = static_cast<std::uint32_t>(station);
    sample.record = records_[station]++;
    sample.time_ns = heard.time_ns;
    sample.has_pose = sample.has_flexion = true;
    sample.pose = chain_.room(wrist, station);
    sample.raw_pose = raw_pose_of(wrist);
    sample.flexion = leap::flexion_of(hand);
    sample.gesture = gestures_[station].update(sample.flexion);
  }
  health_.garbage(heard.time_ns, remove_implausible(out, before));
}

DeviceStatus LeapDevice::status() const {
  DeviceStatus out = health_.status(monotonic_ns());
  if (version_ != leap::known_version && (!socket_ || line_.connected || line_.refused)) {
    out.health = DeviceHealth::babbling;
    out.message =
        fmt::format("{} uses version {}, supported: {}; retrying", where_, version_, leap::known_version);
  } else if (socket_ && !line_.connected) {
    out.health = line_.problem.empty() ? DeviceHealth::connecting : DeviceHealth::absent;
    out.message = line_.problem.empty()
                      ? where_ + " is starting"
                      : fmt::format("{}; check that Ultraleap's tracking WebSocket runs there; retrying",
                                    line_.problem);
  } else if (out.health == DeviceHealth::babbling) {
    out.message = fmt::format(
        "{} sends data that are not hand frames: check that it is Ultraleap's tracking service", where_);
  } else if (out.health == DeviceHealth::silent) {
    out.message = has_camera_ ? fmt::format("{} sends no frames: check that the camera is plugged in", where_)
                              : fmt::format("{} has no active camera: plug it in", where_);
  }
  return out;
}

std::unique_ptr<Device> open_leap(const std::string& path, const Placement& placement,
                                  const GestureThresholds& gestures) {
  const auto at = parse_host_port(path, leap::default_port);
  if (!at)
    throw InputError(
        fmt::format("device 'leap:{}': must be leap:HOST[:PORT], as in leap:localhost:6437", path));
  auto out = std::make_unique<LeapDevice>(at->host + ":" + at->port, placement, gestures);
  out->connect_service(at->host, at->port);
  return out;
}

}  // namespace prosector
