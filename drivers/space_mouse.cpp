#include "drivers/space_mouse.h"

#include <algorithm>
#include <cmath>

#include "common/clock.h"
#include "drivers/line_port.h"

namespace prosector {
namespace {

constexpr double full_speed = 0.25;           // m/s, of a cap that is pushed as far as it goes
constexpr double full_turn = 1.5;             // rad/s
const Vec3 usual_start(0, 1.2, 0.3);          // m: where nothing else is configured
constexpr double rest = 0.03;                 // of a full push: worn caps don't come back to the middle
constexpr double reach = 0.8;                 // m, from where the hand began, each way
constexpr std::int64_t step_ns = 10'000'000;  // between two samples
constexpr double longest_step = 0.1;          // s: a client that was stopped doesn't fling the hand
constexpr std::int64_t push_lasts_ns = 500'000'000;  // spacenavd repeats what is held, several times in this

/// Returns how far an axis is pushed beyond its rest, −1 … 1.
double beyond_rest(std::int32_t counts) {
  const double push = std::clamp(counts / space_mouse::full_push, -1.0, 1.0);
  return std::abs(push) <= rest ? 0 : (push - std::copysign(rest, push)) / (1 - rest);
}

}  // namespace

SpaceMouse::SpaceMouse(std::unique_ptr<DevicePort> port, const DeviceConfig& config)
    : StreamDevice(std::move(port)), config_(config) {
  if (config_.room_device.p.isZero()) config_.room_device.p = usual_start;
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
  if (now_ns - pushed_ns_ > push_lasts_ns) push_ = {};
  move(std::min(1e-9 * static_cast<double>(now_ns - moved_ns_), longest_step));
  moved_ns_ = now_ns;
  DeviceSample& sample = out.emplace_back();
  sample.record = records_++;
  sample.time_ns = now_ns;
  sample.has_pose = true;
  sample.pose = config_.room_device * hand_ * config_.mount[0];
  for (std::size_t i = 0; i < 3; ++i) sample.raw_pose[i] = static_cast<float>(push_[i]);
  sample.buttons = buttons_;
}

void SpaceMouse::take(const space_mouse::Record& record, std::int64_t now_ns) {
  if (record.kind == space_mouse::motion) {
    push_ = record.push;
    pushed_ns_ = now_ns;
  } else if (record.button < buttons_told) {
    const std::uint32_t bit = 1u << record.button;
    buttons_ = record.kind == space_mouse::press ? buttons_ | bit : buttons_ & ~bit;
  }
}

/// Moves the hand in the room's directions, and turns it about its own wrist in these, too.
void SpaceMouse::move(double seconds) {
  const auto vector = [&](std::size_t first) {
    // spacenavd's third axis is away from the user, ours is towards.
    return Vec3(beyond_rest(push_[first]), beyond_rest(push_[first + 1]), -beyond_rest(push_[first + 2]));
  };
  hand_.p = (hand_.p + full_speed * seconds * vector(0)).cwiseMax(-reach).cwiseMin(reach);
  const Vec3 turn = full_turn * seconds * vector(3);
  if (turn.norm() > 0)
    hand_.q = (Quat(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * hand_.q).normalized();
}

/// Takes silence for what it is: a cap that nobody pushes says nothing.
DeviceStatus SpaceMouse::status() const {
  DeviceStatus out = StreamDevice::status();
  if (out.health != DeviceHealth::silent && out.health != DeviceHealth::connecting) return out;
  if (records_ == 0) return out;
  out.health = DeviceHealth::streaming;
  out.message.clear();
  return out;
}

std::string SpaceMouse::silent_hint() const {
  return "nobody pushes its cap";
}

std::string SpaceMouse::babble_hint() const {
  return "what comes are no records of spacenavd";
}

std::string SpaceMouse::absent_hint() const {
  return "check that spacenavd runs, and that you may use its socket";
}

std::unique_ptr<Device> open_space_mouse(const std::string& path, const DeviceConfig& config) {
  return std::make_unique<SpaceMouse>(
      std::make_unique<LinePort>(path, [path] { return connect_local(path); }), config);
}

}  // namespace prosector
