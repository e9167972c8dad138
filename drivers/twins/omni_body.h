#pragma once
// What a simulated PHANTOM Omni is made of: registers, packets and a chain of joints. All of it is written
// from public drivers (docs/look-up/devices.md), and none of it from Prosector's own driver, so that a test
// of one against the other can fail.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/math.h"

namespace prosector::omni_body {

inline constexpr std::size_t command_size = 16, state_size = 44;  // bytes

// Registers, by address.
inline constexpr std::uint64_t vendor_register = 0x1006000c, serial_register = 0x10060010;
inline constexpr std::uint64_t receive_channel = 0x1000, transmit_channel = 0x1001, control_register = 0x1087;
/// Returns the four bytes that a read of an address gives, in the bus' order.
std::array<std::uint8_t, 4> register_bytes(std::uint64_t address);
/// Returns whether a byte written to the control register lets packets flow.
bool starts_packets(std::uint8_t control);

/// Encoder counts, as the arm sends them. All three are absolute: the third measures the lower bar against
/// the base.
using Encoders = std::array<int, 3>;
/// Angles as a chain of joints has them, rad: waist, shoulder, elbow (of the lower bar against the upper
/// one), then the wrist's three.
struct Chain {
  double waist = 0, shoulder = 0, elbow = 0;
  Vec3 wrist = Vec3::Zero();
};

/// Returns encoder counts for angles, where `offset` are the counts at which they were switched on.
Encoders encoders_of(const Chain& chain, const Encoders& offset);
/// Returns the angles of the bars in the inkwell.
Chain in_inkwell();
/// Returns the wrist's centre and the stylus' orientation, in Prosector's frame of an arm.
Pose stylus_of(const Chain& chain);
/// Returns the angles that bring the stylus to a pose; nothing: it is out of reach.
std::optional<Chain> chain_at(const Pose& stylus);

/// What a command packet says.
struct Motors {
  Vec3 shares = Vec3::Zero();  // of full torque, −1 … 1
  bool on = false;
};
/// Returns nothing where it is no command.
std::optional<Motors> motors_of(std::span<const std::uint8_t> packet);
/// Returns the force at the wrist's centre that the motors make, N.
Vec3 force_of(const Chain& chain, const Vec3& shares);

/// Returns a state packet.
std::array<std::uint8_t, state_size> state_packet(const Encoders& encoders, const Vec3& wrist, bool docked,
                                                  std::uint32_t count);

}  // namespace prosector::omni_body
