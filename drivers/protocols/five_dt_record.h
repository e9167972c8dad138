#pragma once
// Formats of 5DT data gloves: 9-byte packets on a serial line, 10-byte packets from a wireless glove, 64-byte
// reports over USB.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "common/hand_pose.h"

namespace prosector::five_dt {

inline constexpr char reset_command = 'A', stream_command = 'D', sample_command = 'C', info_command = 'G';
inline constexpr std::uint8_t reset_answer = 0x55, packet_header = 0x80;
inline constexpr std::size_t info_width = 32;

/// Width in bytes of a packet of the serial 5DT glove: header, five fingers (0 open … 255 flexed), pitch,
/// roll, and the XOR of the seven data bytes.
inline constexpr std::size_t packet_width = 9;
using Packet = std::array<std::uint8_t, packet_width>;

/// Width in bytes of a packet of a wireless 5DT glove: the packet of a serial glove, then a capability byte
/// that states the hand.
inline constexpr std::size_t wireless_width = 10;
inline constexpr std::uint8_t right_capability = 0x01, left_capability = 0x40;
using WirelessPacket = std::array<std::uint8_t, wireless_width>;

/// Width in bytes of a report of the USB 5DT glove, and distance of its fingers in words. A report has 16
/// big-endian words and 32 bytes of unknown meaning. A 5-sensor glove has its fingers at words 0, 3, 6, 9,
/// 12, with 12 bits each; a 14-sensor glove has its proximal joints there.
inline constexpr std::size_t report_width = 64, report_finger_stride = 3;
inline constexpr std::uint16_t max_word = 4095;
using Report = std::array<std::uint8_t, report_width>;

using Counts = std::array<std::uint16_t, fingers>;  // thumb first

/// Encodes a packet of the serial 5DT glove from counts with the thumb first. Packets of right gloves contain
/// thumb to little finger, those of left gloves the reverse.
Packet encode_packet(const Counts& counts, std::uint8_t pitch, std::uint8_t roll, bool left);
std::optional<Counts> decode_packet(std::span<const std::uint8_t> bytes, bool left);

WirelessPacket encode_wireless(const Counts& counts, std::uint8_t pitch, std::uint8_t roll, bool left);
struct Wireless {
  Counts counts{};
  bool left = false;         // capability byte of the glove
  bool checksum_ok = false;  // the checksum is correct; public drivers don't check it
};
/// Decodes a packet of a wireless 5DT glove in the finger order of a `left` or right glove. Returns nothing
/// if the header or the capability byte is wrong. A wrong checksum is only reported in the result.
std::optional<Wireless> decode_wireless(std::span<const std::uint8_t> bytes, bool left);

Report encode_report(const Counts& counts);
/// Decodes a report of the USB 5DT glove to counts, thumb first. Returns nothing if a finger has more than 12
/// bits or all bytes are 0, which no worn glove sends.
std::optional<Counts> decode_report(std::span<const std::uint8_t> bytes);

}  // namespace prosector::five_dt
