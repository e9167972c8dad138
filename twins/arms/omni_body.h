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
/// Returns the four bytes that a simulated PHANTOM Omni sends for a register read at this address, in bus
/// order; zeros for unknown addresses.
std::array<std::uint8_t, 4> register_bytes(std::uint64_t address);
/// Returns whether a byte written to the Omni's control register enables the exchange of packets.
bool starts_packets(std::uint8_t control);

/// Encoder counts as a PHANTOM Omni sends them: waist, shoulder, lower bar. All three angles are absolute:
/// the third encoder measures the lower bar relative to the base, not to the upper bar.
using Encoders = std::array<int, 3>;
/// Joint angles of a PHANTOM Omni as a serial chain, rad: waist, shoulder, elbow (lower bar relative to the
/// upper one), then three wrist angles.
struct Chain {
  double waist = 0, shoulder = 0, elbow = 0;
  Vec3 wrist = Vec3::Zero();
};

/// Returns the encoder counts of a PHANTOM Omni at these joint angles. `offset` holds the counts with the
/// stylus in its inkwell.
Encoders encoders_of(const Chain& chain, const Encoders& offset);
/// Returns the joint angles of a PHANTOM Omni whose stylus is in its inkwell.
Chain in_inkwell();
/// Returns the stylus pose at these joint angles: the position of the wrist's centre (m) and the stylus
/// orientation. It is in the arm frame (x right, y up, z towards the user).
Pose stylus_of(const Chain& chain);
/// Returns the joint angles at which a PHANTOM Omni's stylus has this pose (m, arm frame). Returns nothing if
/// the pose is out of reach.
std::optional<Chain> chain_at(const Pose& stylus);

/// Content of a command packet to a PHANTOM Omni: torques of the motors, and whether the motors are on.
struct Motors {
  Vec3 shares = Vec3::Zero();  // fraction of full torque, −1 … 1
  bool on = false;
};
/// Decodes a command packet to a PHANTOM Omni. Returns nothing if the packet is invalid.
std::optional<Motors> motors_of(std::span<const std::uint8_t> packet);
/// Returns the force (N, arm frame) at the wrist's centre that motor torques of these fractions of full
/// torque exert at these joint angles. Returns zero near a singularity.
Vec3 force_of(const Chain& chain, const Vec3& shares);

/// Encodes a state packet of a PHANTOM Omni. `wrist` holds the three gimbal angles (rad), `docked` says
/// whether the stylus is in its inkwell, and `count` is the packet's running number.
std::array<std::uint8_t, state_size> state_packet(const Encoders& encoders, const Vec3& wrist, bool docked,
                                                  std::uint32_t count);

}  // namespace prosector::omni_body
