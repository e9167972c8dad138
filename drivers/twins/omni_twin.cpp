#include "drivers/twins/omni_twin.h"

#include <algorithm>

#include "drivers/omni_arm_math.h"

namespace prosector {
namespace {

constexpr double docked_seconds = 0.2;   // that the stylus stays in its inkwell after the start …
constexpr double leaving_seconds = 0.8;  // … and that the hand takes from there to where the script begins
constexpr double longest_gap = 0.05;     // s that mechanics catch up at once
constexpr double time_step = 1e-3;       // s, to differentiate the script

ArmMechanics mechanics() {
  ArmMechanics out;
  out.quantum = 0;  // its encoders are at its joints
  return out;
}

}  // namespace

OmniTwin::OmniTwin(OmniTwinOptions options, std::int64_t now_ns)
    : options_(std::move(options)),
      clock_(options_.timing, now_ns),
      model_(mechanics(), options_.hand, omni::tip(omni::docked)),
      random_(options_.seed),
      now_ns_(now_ns),
      intended_(omni::tip(omni::docked)) {
  std::uniform_int_distribution<int> anywhere(-20000, 20000);
  for (int& offset : offset_) offset = anywhere(random_);
}

std::uint32_t OmniTwin::read(std::uint64_t address) const {
  if (address == omni::kind_register) return omni::kind;
  if (address == omni::serial_register) return 0x80000001u | 12345u << 1;
  return 0;
}

void OmniTwin::write(std::uint64_t address, std::span<const std::uint8_t> bytes, std::int64_t now_ns) {
  if (address != omni::control_register || bytes.size() != 1) return;
  const bool streams = (bytes[0] & omni::streams) != 0;
  if (streams && !streaming_) {
    started_ns_ = now_ns;
    docked_ = true;
  }
  streaming_ = streams;
  motors_on_ = false;
  model_.set_force(Vec3::Zero());
}

void OmniTwin::command(std::span<const std::uint8_t> packet) {
  const auto command = omni::command_of(packet);
  if (!command) {
    ++bad_commands_;
    return;
  }
  motors_on_ = command->motors_on;
  const auto joints = omni::joints_at(model_.position());
  model_.set_force(motors_on_ && joints ? omni::force_of(*joints, command->motors) : Vec3(Vec3::Zero()));
}

std::optional<std::array<std::uint8_t, omni::state_bytes>> OmniTwin::advance(std::int64_t now_ns) {
  const double dt = std::min(longest_gap, 1e-9 * static_cast<double>(now_ns - now_ns_));
  now_ns_ = now_ns;
  const double since = 1e-9 * static_cast<double>(now_ns - started_ns_);
  docked_ = !streaming_ || since < docked_seconds;
  if (!docked_ && dt > 0) {
    if (since >= docked_seconds + leaving_seconds) clock_.streaming(now_ns);
    const Wish wanted = wish(now_ns);
    intended_ = wanted.place;
    model_.advance(dt, wanted.place, wanted.velocity);
  }
  if (!streaming_) return std::nullopt;
  std::array<std::uint8_t, omni::state_bytes> packet = omni::bytes_of(state());
  ++count_;
  if (std::uniform_real_distribution<double>(0, 1)(random_) < options_.garbage)
    for (std::uint8_t& byte : packet) byte = static_cast<std::uint8_t>(random_());
  return packet;
}

/// Returns where the hand wants the tip, arm's frame.
OmniTwin::Wish OmniTwin::wish(std::int64_t now_ns) const {
  const Pose to_arm = options_.room_arm.inverse();
  const auto at = [&](double t) { return to_arm * options_.script.pose(0, t, options_.timing.loop).p; };
  const double t = clock_.seconds(now_ns);
  const Vec3 place = at(t), velocity = (at(t + time_step) - at(t - time_step)) / (2 * time_step);
  const double since = 1e-9 * static_cast<double>(now_ns - started_ns_) - docked_seconds;
  if (since >= leaving_seconds) return {place, velocity};
  const double u = std::clamp(since / leaving_seconds, 0., 1.), s = u * u * (3 - 2 * u);
  const Vec3 dock = omni::tip(omni::docked), way = place - dock;
  return {dock + s * way, 6 * u * (1 - u) / leaving_seconds * way};
}

omni::State OmniTwin::state() const {
  omni::State out;
  const auto reached = omni::joints_at(model_.position());
  const omni::Joints joints = docked_ || !reached ? omni::docked : *reached;
  const std::array<int, 3> counts = omni::counts_of(joints);
  for (std::size_t i = 0; i < 3; ++i) out.encoders[i] = static_cast<std::int16_t>(counts[i] + offset_[i]);
  // The hand holds the stylus level, whatever the arm's own turn.
  omni::set_gimbal(out, Vec3(joints[0], 0, 0));
  out.number = static_cast<std::uint8_t>(count_);
  out.count = count_;
  out.docked = docked_;
  return out;
}

}  // namespace prosector
