#include "twins/arms/omni_twin.h"

namespace prosector {
namespace {

constexpr std::int64_t docked_ns = 200'000'000;  // time that the stylus stays in its inkwell after streaming
                                                 // starts

ArmMechanics mechanics() {
  ArmMechanics out;
  out.quantum = 0;  // its encoders are at the joints
  return out;
}

}  // namespace

OmniTwin::OmniTwin(OmniTwinOptions options, std::int64_t now_ns)
    : garbage_(options.garbage),
      arm_(std::move(static_cast<HeldArmOptions&>(options)), mechanics(),
           omni_body::stylus_of(omni_body::in_inkwell()).p, now_ns),
      random_(options.seed) {
  std::uniform_int_distribution<int> anywhere(-20000, 20000);
  for (int& offset : offset_) offset = anywhere(random_);
}

void OmniTwin::write(std::uint64_t address, std::span<const std::uint8_t> bytes, std::int64_t now_ns) {
  if (bytes.size() != 1) return;
  if (address == omni_body::receive_channel) receives_on_ = bytes[0];
  if (address == omni_body::transmit_channel) transmits_on_ = bytes[0];
  if (address != omni_body::control_register) return;
  // Packets are lost if both directions use the same channel.
  const bool streams =
      omni_body::starts_packets(bytes[0]) && receives_on_ && transmits_on_ && receives_on_ != transmits_on_;
  if (streams != streaming_) arm_.put_down();
  if (streams && !streaming_) started_ns_ = now_ns;
  streaming_ = streams;
  arm_.set_force(Vec3::Zero());
}

void OmniTwin::command(std::span<const std::uint8_t> packet) {
  const auto motors = omni_body::motors_of(packet);
  if (!motors) {
    ++bad_commands_;
    return;
  }
  const auto chain = omni_body::chain_at({model().position(), Quat::Identity()});
  arm_.set_force(motors->on && chain ? omni_body::force_of(*chain, motors->shares) : Vec3(Vec3::Zero()));
}

std::optional<std::array<std::uint8_t, omni_body::state_size>> OmniTwin::advance(std::int64_t now_ns) {
  if (streaming_ && now_ns - started_ns_ >= docked_ns) arm_.take(started_ns_ + docked_ns);
  arm_.advance(now_ns);
  if (!streaming_) return std::nullopt;
  std::array<std::uint8_t, omni_body::state_size> packet = state();
  ++count_;
  if (std::uniform_real_distribution<double>(0, 1)(random_) < garbage_)
    for (std::uint8_t& byte : packet) byte = static_cast<std::uint8_t>(random_());
  return packet;
}

std::array<std::uint8_t, omni_body::state_size> OmniTwin::state() const {
  const auto reached = omni_body::chain_at({model().position(), arm_.orientation()});
  const omni_body::Chain chain = !arm_.taken() || !reached ? omni_body::in_inkwell() : *reached;
  return omni_body::state_packet(omni_body::encoders_of(chain, offset_), chain.wrist, !arm_.taken(), count_);
}

}  // namespace prosector
