#pragma once
// Identities, roles, simulated time and limits that all messages share. Lengths are in metres, times in
// ticks.

#include <cstddef>
#include <cstdint>

namespace prosector {

using ParticipantId = std::uint64_t;  // drawn at random by each client; 0 is nobody
using BodyId = std::uint32_t;         // index into SceneInfo::bodies

enum class Role : std::uint8_t { observer, dissector, host };

inline constexpr std::size_t left_hand = 0, right_hand = 1;

inline constexpr std::uint32_t protocol_version = 10;

inline constexpr std::size_t max_name_length = 63;    // bytes, UTF-8: session, participant, body names
inline constexpr std::size_t max_text_length = 1023;  // bytes: descriptions, reasons

inline constexpr double max_coordinate = 1000.0;  // metres: positions beyond it are refused

/// Simulated time: the number of the tick (time step), and of the epoch. A rewind starts a new epoch, so
/// (epoch, tick) never repeats.
struct SimTime {
  std::uint32_t epoch = 0;
  std::uint64_t tick = 0;
  auto operator<=>(const SimTime&) const = default;
};

/// One hand of a participant, left or right, for instance as the holder of a body.
struct HandRef {
  ParticipantId participant = 0;
  std::uint8_t hand = right_hand;
  auto operator<=>(const HandRef&) const = default;
};

inline constexpr std::size_t step_phases = 8;

}  // namespace prosector
