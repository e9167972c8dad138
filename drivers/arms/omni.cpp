#include "drivers/arms/omni.h"

#include <fmt/format.h>

#include <utility>

#include "common/commands.h"
#include "drivers/device/plausible.h"

namespace prosector {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t reopen_ns = 500 * ms;
constexpr std::int64_t quiet_ns = 20 * ms;  // time without a packet after which the pose is not valid
constexpr std::int64_t silence_timeout_ns =
    500 * ms;  // time without a packet after which the connection is reopened

constexpr std::uint8_t dock_light = 3;

}  // namespace

OmniArm::OmniArm(std::unique_ptr<omni::Line> line, const ArmConfig& config,
                 std::function<std::int64_t()> clock)
    : line_(std::move(line)), config_(config), clock_(std::move(clock)) {}

OmniArm::~OmniArm() {
  if (!line_->is_open()) return;
  line_->send(omni::bytes_of(omni::Command{}));
  const std::uint8_t off = 0;
  line_->write(omni::control_register, {&off, 1});
}

ArmLimits omni_limits() {
  ArmLimits out;  // data sheet: docs/do/arms.md
  out.low = {-0.08, -0.06, -0.035};
  out.high = {0.08, 0.06, 0.035};
  out.peak_force = 3.3;
  out.continuous_force = 0.88;
  out.stiffness = 1020;
  out.max_slew = 1500;
  return out;
}

ArmReading OmniArm::read() {
  const std::int64_t now = clock_();
  if (!line_->is_open() && !open(now)) return {};
  while (const auto packet = line_->receive()) {
    if (const auto state = omni::state_of(*packet)) {
      take(*state, now);
    } else {
      last_packet_unreadable_ = true;
      ++status_.resyncs;
      status_.skipped_bytes += omni::state_bytes;
    }
  }
  if (now - heard_ns_ > silence_timeout_ns || !line_->is_open()) lose();
  return reading(now);
}

/// Performs the arm's start-up sequence if a retry is due. Returns whether the connection is open.
bool OmniArm::open(std::int64_t now_ns) {
  if (now_ns < next_open_ns_) return false;
  next_open_ns_ = now_ns + reopen_ns;
  status_.health = DeviceHealth::absent;
  if (!line_->open()) {
    status_.message = fmt::format("{}; retrying twice per second", line_->error());
    return false;
  }
  const auto kind = line_->read(omni::kind_register);
  if (!kind || omni::number_of(*kind) != omni::kind) {
    status_.message = kind ? fmt::format("the FireWire device found is not an Omni (device kind {:08x})",
                                         omni::number_of(*kind))
                           : "no response";
    line_->close();
    return false;
  }
  const auto byte = [&](std::uint64_t address, std::uint8_t value) {
    return line_->write(address, {&value, 1});
  };
  const auto channels = line_->start();
  if (!channels || !byte(omni::to_arm_channel, channels->to_arm) ||
      !byte(omni::from_arm_channel, channels->from_arm) ||
      !line_->write(omni::start_register, omni::start_word) || !byte(omni::control_register, omni::streams)) {
    status_.message = channels ? "it cannot be started" : line_->error();
    line_->close();
    return false;
  }
  if (status_.records > 0) ++status_.reopens;
  status_.health = DeviceHealth::connecting;
  heard_ns_ = now_ns;
  last_.reset();
  homed_ = armed_ = false;
  return true;
}

void OmniArm::take(const omni::State& state, std::int64_t now_ns) {
  for (std::size_t i = 0; i < 3; ++i) {
    const int before = last_ ? last_->encoders[i] : state.encoders[i];
    // The 16-bit counters wrap around; a change is less than half of their range.
    counts_[i] += static_cast<std::int16_t>(state.encoders[i] - before);
  }
  if (state.docked) {
    home_ = counts_;
    homed_ = true;
  }
  joints_ = omni::joints_of({counts_[0] - home_[0], counts_[1] - home_[1], counts_[2] - home_[2]});
  last_ = state;
  last_packet_unreadable_ = false;
  heard_ns_ = now_ns;
  ++status_.records;
}

ArmReading OmniArm::reading(std::int64_t now_ns) const {
  ArmReading out;
  if (!last_) return out;
  const Pose stylus = {omni::tip(joints_), omni::orientation(joints_, omni::gimbal_of(*last_))};
  out.stylus = config_.room_arm * stylus;
  out.buttons = last_->buttons;
  out.valid = homed_ && !last_->docked && now_ns - heard_ns_ <= quiet_ns;
  return out;
}

void OmniArm::lose() {
  line_->close();
  last_.reset();
  homed_ = armed_ = false;
  status_.health = DeviceHealth::silent;
  status_.message = !line_->error().empty() ? line_->error()
                    : last_packet_unreadable_
                        ? "the device sends packets that are not those of an Omni"
                        : "the arm has sent no packet for half a second: check its power and cable";
}

void OmniArm::set_force(const Vec3& force) {
  if (!line_->is_open()) return;
  omni::Command command;
  command.light = homed_ ? 0 : dock_light;
  if (homed_ && last_) {
    command.motors = omni::commands_for(
        joints_, config_.room_arm.q.conjugate() * bounded_force(force, limits_.peak_force));
    // The motors are armed by a packet with motors off, followed by one with motors on.
    command.motors_on = std::exchange(armed_, true);
  } else {
    armed_ = false;
  }
  line_->send(omni::bytes_of(command));
}

DeviceStatus OmniArm::status() const {
  DeviceStatus out = status_;
  if (last_) {
    out.health = DeviceHealth::streaming;
    out.message = homed_ ? "" : "put the stylus into its inkwell: the arm is not calibrated yet";
  }
  return out;
}

std::unique_ptr<Arm> open_omni(const std::string& port, const ArmConfig& config) {
  return std::make_unique<OmniArm>(omni::make_firewire_line(port), config);
}

std::unique_ptr<Arm> open_omni_twin(const std::string& path, const ArmConfig& config) {
  return std::make_unique<OmniArm>(omni::make_socket_line(path), config);
}

}  // namespace prosector
