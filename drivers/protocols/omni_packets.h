#pragma once
// Packet formats of a PHANTOM Omni on FireWire, after public drivers (docs/look-up/devices.md).

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/math.h"

namespace prosector::omni {

// Addresses in the node's address space. Registers of 32 bits are big endian; bytes are given in bus order.
inline constexpr std::uint64_t kind_register = 0x1006000c;
inline constexpr std::uint32_t kind = 0x000b9900;  // value of that register for an Omni: the vendor number,
                                                   // then a zero
using Word = std::array<std::uint8_t, 4>;
inline std::uint32_t number_of(const Word& w) {
  return std::uint32_t{w[0]} << 24 | std::uint32_t{w[1]} << 16 | std::uint32_t{w[2]} << 8 | w[3];
}
inline constexpr std::uint64_t to_arm_channel = 0x1000, from_arm_channel = 0x1001, control_register = 0x1087,
                               start_register = 0x20010;
inline constexpr Word start_word = {0x00, 0x00, 0x0f, 0xf8};  // public drivers on x86 write it as 0xf80f0000
inline constexpr std::uint8_t streams = 0x08;                 // bit of the control register that enables
                                                              // packets

inline constexpr std::size_t command_bytes = 16, state_bytes = 44;

/// Command packet to a PHANTOM Omni, which the host sends 1000 times a second: motor commands and brightness
/// of the dock light.
struct Command {
  Vec3 motors = Vec3::Zero();  // fraction of full command, −1 … 1
  bool motors_on = false;
  std::uint8_t light = 0;  // 0 … 3, brightness of the dock light
};
std::array<std::uint8_t, command_bytes> bytes_of(const Command& command);

/// State packet of a PHANTOM Omni, which the arm sends 1000 times a second: encoder counts, gimbal
/// potentiometers, buttons, and whether the stylus is in its dock.
struct State {
  std::array<std::int16_t, 3> encoders{};
  std::array<std::uint16_t, 3> pots_a{}, pots_b{};  // two potentiometer readings per gimbal axis
  std::uint8_t number = 0;
  std::uint32_t buttons = 0;  // bits 0, 1: buttons pressed
  bool docked = false;
  std::uint32_t count = 0;
};
/// Decodes a state packet of a PHANTOM Omni. Returns nothing if the packet is not an Omni's, or if both
/// readings of a potentiometer are zero.
std::optional<State> state_of(std::span<const std::uint8_t> bytes);

/// Computes the three gimbal angles of a PHANTOM Omni, rad, from the potentiometer readings of a decoded
/// state.
Vec3 gimbal_of(const State& state);

}  // namespace prosector::omni
