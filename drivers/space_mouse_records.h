#pragma once
// What spacenavd says at its socket: records of eight numbers of 32 bits, in the machine's own byte order.

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace prosector::space_mouse {

inline constexpr std::size_t record_width = 32;  // bytes
inline constexpr std::size_t axes = 6;           // right, up, away from the user; turns about these
inline constexpr double full_push = 350;         // counts: about what the cap gives at most

enum Kind : std::int32_t { motion = 0, press = 1, release = 2 };

struct Record {
  std::int32_t kind = motion;
  std::array<std::int32_t, axes> push{};  // of a motion, counts
  std::int32_t period_ms = 0;             // since the motion before it
  std::int32_t button = 0;                // of the others, from 0
};

/// Reads a record. Returns nothing for what can be none.
std::optional<Record> decode(std::span<const std::uint8_t> bytes);
std::array<std::uint8_t, record_width> encode(const Record& record);

}  // namespace prosector::space_mouse
