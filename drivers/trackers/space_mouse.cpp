#include "drivers/trackers/space_mouse.h"

#include <algorithm>
#include <cmath>

#include "common/clock.h"
#include "drivers/ports/stream_port.h"

namespace prosector {
namespace {

constexpr double full_speed = 0.25;           // m/s, at full deflection of the cap
constexpr double full_turn = 1.5;             // rad/s, at full deflection
const Vec3 usual_start(0, 1.2, 0.3);          // m: default start position
constexpr double rest = 0.03;                 // dead zone, of the full deflection: worn caps don't return
                                              // exactly to the middle
constexpr double reach = 0.8;                 // m, maximum displacement from the start, per axis and
                                              // direction
constexpr std::int64_t step_ns = 10'000'000;  // between two samples
constexpr double longest_step = 0.1;          // s: limits the hand's motion after the client was suspended
constexpr std::int64_t deflection_timeout_ns = 500'000'000;  // expiry of a deflection; spacenavd repeats a
                                                             // held one several times in this period

/// Returns the deflection of an axis beyond its dead zone, −1 … 1.
double beyond_rest(std::int32_t counts) {
  const double push = std::clamp(counts / space_mouse::full_push, -1.0, 1.0);
  return std::abs(push) <= rest ? 0 : (push - std::copysign(rest, push)) / (1 - rest);
}

}  // namespace

SpaceMouse::SpaceMouse(std::unique_ptr<DevicePort> port, const Placement& placement)
    : StreamDevice(std::move(port)), placement_(placement) {
  if (placement_.room_device.p.isZero()) placement_.room_device.p = usual_start;
}

void SpaceMouse::started(std::int64_t now_ns) {
  push_ = {};
  buttons_ = 0;
  moved_ns_ = now_ns;
}

void SpaceMouse::parse(std::int64_t now_ns, std::vector<DeviceSample>& out) {
  std::size_t skipped = 0;
  while (buffer().bytes().size() >= space_mouse::record_width) {
    const auto record = space_mouse::decode(buffer().bytes().first(space_mouse::record_width));
    if (record) {
      health().garbage(now_ns, skipped);
      skipped = 0;
      health().record(now_ns, space_mouse::record_width);
      take(*record, now_ns);
    } else {
      ++skipped;
    }
    buffer().drop(record ? space_mouse::record_width : 1);
  }
  health().garbage(now_ns, skipped);
  if (now_ns - moved_ns_ < step_ns) return;
  if (now_ns - pushed_ns_ > deflection_timeout_ns) push_ = {};
  move(std::min(1e-9 * static_cast<double>(now_ns - moved_ns_), longest_step));
  moved_ns_ = now_ns;
  DeviceSample& sample = out.emplace_back();
  sample.record = records_++;
  sample.time_ns = now_ns;
  sample.has_pose = true;
  sample.pose = placement_.room_device * hand_ * placement_.mount[0];
  for (std::size_t i = 0; i < 3; ++i) sample.raw_pose[i] = static_cast<float>(push_[i]);
  sample.buttons = buttons_;
}

void SpaceMouse::take(const space_mouse::Record& record, std::int64_t now_ns) {
  if (record.kind == space_mouse::motion) {
    push_ = record.push;
    pushed_ns_ = now_ns;
  } else if (record.button < max_sample_buttons) {
    const std::uint32_t bit = 1u << record.button;
    buttons_ = record.kind == space_mouse::press ? buttons_ | bit : buttons_ & ~bit;
  }
}

/// Translates the hand along the device's axes in the room, and rotates it about its wrist around the same
/// axes.
void SpaceMouse::move(double seconds) {
  const auto vector = [&](std::size_t first) {
    // spacenavd's third axis points away from the user, Prosector's towards the user.
    return Vec3(beyond_rest(push_[first]), beyond_rest(push_[first + 1]), -beyond_rest(push_[first + 2]));
  };
  hand_.p = (hand_.p + full_speed * seconds * vector(0)).cwiseMax(-reach).cwiseMin(reach);
  const Vec3 turn = full_turn * seconds * vector(3);
  if (turn.norm() > 0)
    hand_.q = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * hand_.q).normalized();
}

/// Reports a silent device as streaming, since spacenavd sends nothing while the cap is at rest.
DeviceStatus SpaceMouse::status() const {
  DeviceStatus out = StreamDevice::status();
  if (out.health != DeviceHealth::silent && out.health != DeviceHealth::connecting) return out;
  if (records_ == 0) return out;
  out.health = DeviceHealth::streaming;
  out.message.clear();
  return out;
}

std::string SpaceMouse::silent_hint() const {
  return "the SpaceMouse's cap is not moved: move it once";
}

std::string SpaceMouse::babble_hint() const {
  return "the received data are not spacenavd records: check the socket's path";
}

std::string SpaceMouse::absent_hint() const {
  return "check that spacenavd runs, and that you have permission for its socket";
}

std::unique_ptr<Device> open_space_mouse(const std::string& path, const Placement& placement) {
  return std::make_unique<SpaceMouse>(
      std::make_unique<StreamPort>(path, [path] { return connect_local(path); }), placement);
}

}  // namespace prosector
