#pragma once
// Records of spacenavd's socket: eight 32-bit numbers in the machine's byte order.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace prosector::space_mouse {

inline constexpr std::size_t record_width = 32;  // bytes
inline constexpr std::size_t axes = 6;           // right, up, away from the user; rotations about these
inline constexpr double full_push = 350;         // counts: approximate maximum deflection

enum Kind : std::int32_t { motion = 0, press = 1, release = 2 };

struct Record {
  std::int32_t kind = motion;
  std::array<std::int32_t, axes> push{};  // of a motion record: deflections, counts
  std::int32_t period_ms = 0;             // time since the previous motion record
  std::int32_t button = 0;                // of a press or release record, from 0
};

/// Decodes a record of spacenavd's socket: a motion, or a button pressed or released. Returns nothing if the
/// record is invalid.
std::optional<Record> decode(std::span<const std::uint8_t> bytes);
std::array<std::uint8_t, record_width> encode(const Record& record);

}  // namespace prosector::space_mouse
