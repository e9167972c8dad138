#include "drivers/arms/inverse3.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "common/error.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

/// Conditions in the published samples.
enum Heard : int { good, no_state, no_arm };

}  // namespace

ArmLimits inverse3_limits() {
  ArmLimits out;
  out.low = {-0.1, 0, -0.15};
  out.high = {0.1, 0.3, -0.05};
  out.peak_force = 8;
  out.continuous_force = 3;
  out.stiffness = 2000;
  out.max_slew = 1500;
  return out;
}

Inverse3Arm::Inverse3Arm(const ArmConfig& config, std::function<std::int64_t()> clock)
    : config_(config), clock_(std::move(clock)) {}

void Inverse3Arm::connect_service(const std::string& host, const std::string& port) {
  socket_ = std::make_unique<WebSocket>(
      host, port, "/", [this](std::string_view text) { return std::vector<std::string>{handle_text(text)}; });
}

std::string Inverse3Arm::handle_text(std::string_view text) {
  heard_.time_ns = clock_();
  heard_.reading.valid = false;
  const Mat3 to_arm = inverse3::axes();
  const auto state = inverse3::state_of(text);
  const bool one = state && !state->device.empty();
  const Quat axes(to_arm);
  const auto stylus =
      one ? plausible_pose(to_arm * state->place, axes * state->turn * axes.conjugate(), arm_reach)
          : std::nullopt;
  if (stylus) {
    heard_.reading.valid = true;
    heard_.reading.stylus = *stylus;
    heard_.reading.buttons = state->buttons;
  }
  heard_.condition = stylus ? good : state && !one ? no_arm : no_state;
  ++(heard_.condition == no_state ? heard_.bad : heard_.records);
  exchange_.publish(heard_);
  inverse3::Force answer;
  if (one) answer.device = state->device;
  if (stylus)
    answer.force = to_arm.transpose() * (config_.room_arm.q.conjugate() * exchange_.force(heard_.time_ns));
  return inverse3::text_of(answer);
}

ArmReading Inverse3Arm::read() {
  if (socket_) line_ = socket_->state();
  last_ = exchange_.sample();
  return exchange_.reading(clock_(), config_.room_arm);
}

void Inverse3Arm::set_force(const Vec3& force) {
  exchange_.set_force(force, limits_.peak_force, clock_());
}

DeviceStatus Inverse3Arm::status() const {
  DeviceStatus out;
  out.records = last_.records;
  out.resyncs = last_.bad;
  out.reopens = std::max<std::uint64_t>(line_.connections, 1) - 1;
  out.message = line_.problem;
  if (socket_ && !line_.connected) {
    out.health = line_.problem.empty() ? DeviceHealth::connecting : DeviceHealth::absent;
  } else if (last_.time_ns == 0) {
    out.health = DeviceHealth::connecting;
  } else if (last_.condition == no_arm) {
    out.health = DeviceHealth::absent;
    out.message = "the service runs, but no Inverse3 is connected";
  } else {
    out.health = last_.condition == good ? DeviceHealth::streaming : DeviceHealth::babbling;
    if (last_.condition == no_state)
      out.message = "received data is not an Inverse3 state: check the service's version";
  }
  return out;
}

std::unique_ptr<Arm> open_inverse3(const std::string& path, const ArmConfig& config) {
  const auto colon = path.rfind(':');
  const std::string port = colon == std::string::npos ? "" : path.substr(colon + 1);
  if (colon == 0 || port.empty() || port.size() > 5 ||
      !std::all_of(port.begin(), port.end(), [](unsigned char c) { return std::isdigit(c) != 0; }))
    throw InputError(
        fmt::format("arm 'inverse3:{}': must be inverse3:HOST:PORT, as in inverse3:localhost:10001", path));
  auto out = std::make_unique<Inverse3Arm>(config);
  out->connect_service(path.substr(0, colon), port);
  return out;
}

}  // namespace prosector
