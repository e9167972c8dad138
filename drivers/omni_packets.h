#pragma once
// The bytes of a PHANTOM Omni on FireWire, as public drivers have them (docs/do/arms.md).

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/math.h"

namespace prosector::omni {

// Addresses of its register space, added to the bus' 0x1 0000 0000.
inline constexpr std::uint64_t kind_register = 0x1006000c, serial_register = 0x10060010;
inline constexpr std::uint32_t kind = 0x000b9900;  // that it answers
inline constexpr std::uint64_t to_arm_channel = 0x1000, from_arm_channel = 0x1001, control_register = 0x1087,
                               start_register = 0x20010;
inline constexpr std::uint32_t start_word = 0xf80f0000;
inline constexpr std::uint8_t streams = 0x08;  // bit of the control register

inline constexpr std::size_t command_bytes = 16, state_bytes = 44;

/// What the host sends a thousand times a second.
struct Command {
  Vec3 motors = Vec3::Zero();  // share of full command, −1 … 1
  bool motors_on = false;
  std::uint8_t light = 0;  // 0 … 3, of the dock
};
std::array<std::uint8_t, command_bytes> bytes_of(const Command& command);
std::optional<Command> command_of(std::span<const std::uint8_t> bytes);

/// What the arm sends as often.
struct State {
  std::array<std::int16_t, 3> encoders{};
  std::array<std::uint16_t, 3> pots_a{}, pots_b{};  // of the gimbal
  std::uint8_t number = 0;
  std::uint32_t buttons = 0;  // bits 0, 1: pressed
  bool docked = false;
  std::uint32_t count = 0;
};
std::array<std::uint8_t, state_bytes> bytes_of(const State& state);
/// Returns nothing where it is no packet of an Omni.
std::optional<State> state_of(std::span<const std::uint8_t> bytes);

/// Returns the gimbal's angles from the pots, rad.
Vec3 gimbal_of(const State& state);
/// Fills in pots that say so.
void set_gimbal(State& state, const Vec3& gimbal);

/// Returns the serial number that is printed on it, from its register; 0: none is in it.
std::uint32_t serial_of(std::uint32_t word);

}  // namespace prosector::omni
