#pragma once
// Registers, packets and joint chain of a simulated PHANTOM Omni. The code follows public drivers
// (docs/look-up/devices.md) and shares nothing with Prosector's own driver, so that tests of one against the
// other can detect errors.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/math.h"

namespace prosector::omni_body {

inline constexpr std::size_t command_size = 16, state_size = 44;  // bytes

// Register addresses.
inline constexpr std::uint64_t vendor_register = 0x1006000c, serial_register = 0x10060010;
inline constexpr std::uint64_t receive_channel = 0x1000, transmit_channel = 0x1001, control_register = 0x1087;
/// Returns the four bytes of a register read at an address, in bus order.
std::array<std::uint8_t, 4> register_bytes(std::uint64_t address);
/// Returns whether a byte written to the control register enables packets.
bool starts_packets(std::uint8_t control);

/// Encoder counts, as the arm sends them. All three are absolute: the third measures the lower bar relative
/// to the base.
using Encoders = std::array<int, 3>;
/// Joint angles of a serial chain, rad: waist, shoulder, elbow (lower bar relative to the upper one), then
/// three wrist angles.
struct Chain {
  double waist = 0, shoulder = 0, elbow = 0;
  Vec3 wrist = Vec3::Zero();
};

/// Returns encoder counts for joint angles. `offset` are the counts in the inkwell.
Encoders encoders_of(const Chain& chain, const Encoders& offset);
/// Returns the joint angles with the stylus in the inkwell.
Chain in_inkwell();
/// Returns the wrist's centre and the stylus orientation, in Prosector's arm frame.
Pose stylus_of(const Chain& chain);
/// Returns the joint angles for a stylus pose; nothing if it is out of reach.
std::optional<Chain> chain_at(const Pose& stylus);

/// Content of a command packet.
struct Motors {
  Vec3 shares = Vec3::Zero();  // fraction of full torque, −1 … 1
  bool on = false;
};
/// Decodes a command packet. Returns nothing if it is invalid.
std::optional<Motors> motors_of(std::span<const std::uint8_t> packet);
/// Returns the motors' force at the wrist's centre, N.
Vec3 force_of(const Chain& chain, const Vec3& shares);

/// Encodes a state packet.
std::array<std::uint8_t, state_size> state_packet(const Encoders& encoders, const Vec3& wrist, bool docked,
                                                  std::uint32_t count);

}  // namespace prosector::omni_body
