#include "drivers/protocols/omni_packets.h"

#include <algorithm>
#include <cmath>

namespace prosector::omni {
namespace {

constexpr int no_command = 0x7ff, most_command = 4095;
constexpr std::uint16_t status_word = 0x53c0, light_bits = 0x3, motor_bit = 0x8;
constexpr std::uint16_t second_word = 0x001e, late_word = 0x5746;  // constant in all observed packets, at
                                                                   // bytes 2 and 28
constexpr std::array<double, 3> pot_gain = {5.48, -5.28, 4.76}, pot_offset = {-2.74, 2.64, -2.38};
constexpr std::uint16_t pot_noise = 0x1f;

int pot(std::uint16_t counts) {
  return counts & ~pot_noise;
}

template <std::size_t N>
void put16(std::array<std::uint8_t, N>& out, std::size_t at, int value) {
  out[at] = static_cast<std::uint8_t>(value & 0xff);
  out[at + 1] = static_cast<std::uint8_t>(value >> 8 & 0xff);
}
std::uint16_t get16(std::span<const std::uint8_t> in, std::size_t at) {
  return static_cast<std::uint16_t>(in[at] | in[at + 1] << 8);
}

}  // namespace

std::array<std::uint8_t, command_bytes> bytes_of(const Command& command) {
  std::array<std::uint8_t, command_bytes> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = std::clamp(command.motors[static_cast<Eigen::Index>(i)], -1., 1.);
    const int value = share == 0 || !std::isfinite(share)
                          ? no_command
                          : static_cast<int>(std::lround((share + 1) / 2 * most_command));
    put16(out, 2 * i, value);
  }
  put16(out, 6, status_word | (command.light & light_bits) | (command.motors_on ? motor_bit : 0));
  return out;
}

std::optional<State> state_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != state_bytes || get16(bytes, 0) != 0 || get16(bytes, 2) != second_word ||
      get16(bytes, 28) != late_word)
    return std::nullopt;
  State out;
  for (std::size_t i = 0; i < 3; ++i) {
    out.encoders[i] = static_cast<std::int16_t>(get16(bytes, 4 + 2 * i));
    out.pots_a[i] = get16(bytes, 10 + 2 * i);
    out.pots_b[i] = get16(bytes, 22 + 2 * i);
    if (pot(out.pots_a[i]) + pot(out.pots_b[i]) == 0) return std::nullopt;
  }
  out.number = bytes[18];
  out.buttons = ~bytes[19] & 3u;
  out.docked = (bytes[19] & 4) == 0;
  for (std::size_t i = 0; i < 4; ++i) out.count |= std::uint32_t{bytes[32 + i]} << (8 * i);
  return out;
}

Vec3 gimbal_of(const State& state) {
  Vec3 out;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = pot(state.pots_a[i]), b = pot(state.pots_b[i]);
    out[static_cast<Eigen::Index>(i)] = pot_gain[i] * a / (a + b) + pot_offset[i];
  }
  return out;
}

}  // namespace prosector::omni
