#include "drivers/protocols/five_dt_record.h"

#include <algorithm>

namespace prosector::five_dt {
namespace {

std::size_t place(std::size_t finger, bool left) {
  return left ? fingers - 1 - finger : finger;
}

std::uint8_t checksum(std::span<const std::uint8_t> packet) {
  std::uint8_t sum = 0;
  for (const std::uint8_t byte : packet.subspan(1, packet_width - 2)) sum ^= byte;
  return sum;
}

Counts counts_of(std::span<const std::uint8_t> packet, bool left) {
  Counts counts{};
  for (std::size_t i = 0; i < fingers; ++i) counts[i] = packet[1 + place(i, left)];
  return counts;
}

}  // namespace

Packet encode_packet(const Counts& counts, std::uint8_t pitch, std::uint8_t roll, bool left) {
  Packet packet{};
  packet[0] = packet_header;
  for (std::size_t i = 0; i < fingers; ++i) packet[1 + place(i, left)] = static_cast<std::uint8_t>(counts[i]);
  packet[6] = pitch;
  packet[7] = roll;
  packet[8] = checksum(packet);
  return packet;
}

std::optional<Counts> decode_packet(std::span<const std::uint8_t> bytes, bool left) {
  if (bytes.size() != packet_width || bytes[0] != packet_header || bytes[8] != checksum(bytes))
    return std::nullopt;
  return counts_of(bytes, left);
}

WirelessPacket encode_wireless(const Counts& counts, std::uint8_t pitch, std::uint8_t roll, bool left) {
  WirelessPacket packet{};
  std::ranges::copy(encode_packet(counts, pitch, roll, left), packet.begin());
  packet.back() = left ? left_capability : right_capability;
  return packet;
}

std::optional<Wireless> decode_wireless(std::span<const std::uint8_t> bytes, bool left) {
  if (bytes.size() != wireless_width || bytes.front() != packet_header ||
      (bytes.back() != right_capability && bytes.back() != left_capability))
    return std::nullopt;
  const auto packet = bytes.first(packet_width);
  return Wireless{counts_of(packet, left), bytes.back() == left_capability,
                  packet.back() == checksum(packet)};
}

Report encode_report(const Counts& counts) {
  Report report{};
  for (std::size_t i = 0; i < fingers; ++i) {
    const std::size_t at = 2 * report_finger_stride * i;
    report[at] = static_cast<std::uint8_t>(counts[i] >> 8);
    report[at + 1] = static_cast<std::uint8_t>(counts[i] & 0xff);
  }
  return report;
}

std::optional<Counts> decode_report(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != report_width) return std::nullopt;
  if (std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; })) return std::nullopt;
  Counts counts{};
  for (std::size_t i = 0; i < fingers; ++i) {
    const std::size_t at = 2 * report_finger_stride * i;
    counts[i] = static_cast<std::uint16_t>(bytes[at] << 8 | bytes[at + 1]);
    if (counts[i] > max_word) return std::nullopt;
  }
  return counts;
}

}  // namespace prosector::five_dt
