#include "drivers/twins/omni_twin.h"

#include "drivers/omni_arm_math.h"

namespace prosector {
namespace {

constexpr std::int64_t docked_ns = 200'000'000;  // that the stylus stays in its inkwell after the start

ArmMechanics mechanics() {
  ArmMechanics out;
  out.quantum = 0;  // its encoders are at its joints
  return out;
}

}  // namespace

OmniTwin::OmniTwin(OmniTwinOptions options, std::int64_t now_ns)
    : garbage_(options.garbage),
      arm_(std::move(static_cast<HeldArmOptions&>(options)), mechanics(), omni::tip(omni::docked), now_ns),
      random_(options.seed) {
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
  if (streams != streaming_) arm_.put_down();
  if (streams && !streaming_) started_ns_ = now_ns;
  streaming_ = streams;
  arm_.set_force(Vec3::Zero());
}

void OmniTwin::command(std::span<const std::uint8_t> packet) {
  const auto command = omni::command_of(packet);
  if (!command) {
    ++bad_commands_;
    return;
  }
  const auto joints = omni::joints_at(model().position());
  arm_.set_force(command->motors_on && joints ? omni::force_of(*joints, command->motors)
                                              : Vec3(Vec3::Zero()));
}

std::optional<std::array<std::uint8_t, omni::state_bytes>> OmniTwin::advance(std::int64_t now_ns) {
  if (streaming_ && now_ns - started_ns_ >= docked_ns) arm_.take(started_ns_ + docked_ns);
  arm_.advance(now_ns);
  if (!streaming_) return std::nullopt;
  std::array<std::uint8_t, omni::state_bytes> packet = omni::bytes_of(state());
  ++count_;
  if (std::uniform_real_distribution<double>(0, 1)(random_) < garbage_)
    for (std::uint8_t& byte : packet) byte = static_cast<std::uint8_t>(random_());
  return packet;
}

omni::State OmniTwin::state() const {
  omni::State out;
  const auto reached = omni::joints_at(model().position());
  const omni::Joints joints = !arm_.taken() || !reached ? omni::docked : *reached;
  const std::array<int, 3> counts = omni::counts_of(joints);
  for (std::size_t i = 0; i < 3; ++i) out.encoders[i] = static_cast<std::int16_t>(counts[i] + offset_[i]);
  // The hand holds the stylus level, whatever the arm's own turn.
  omni::set_gimbal(out, Vec3(joints[0], 0, 0));
  out.number = static_cast<std::uint8_t>(count_);
  out.count = count_;
  out.docked = !arm_.taken();
  return out;
}

}  // namespace prosector
