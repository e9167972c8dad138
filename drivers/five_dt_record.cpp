#include "drivers/five_dt_record.h"

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
  Counts counts{};
  for (std::size_t i = 0; i < fingers; ++i) counts[i] = bytes[1 + place(i, left)];
  return counts;
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
  // No glove bends nothing at all: this is a device that reads as zeros.
  if (std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; })) return std::nullopt;
  std::array<std::uint16_t, report_words> words{};
  for (std::size_t i = 0; i < report_words; ++i) {
    words[i] = static_cast<std::uint16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
    if (words[i] > max_word) return std::nullopt;
  }
  Counts counts{};
  for (std::size_t i = 0; i < fingers; ++i) counts[i] = words[report_finger_stride * i];
  return counts;
}

}  // namespace prosector::five_dt
