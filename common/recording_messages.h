#pragma once
// Messages about a recording that is played back.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// Kind of an event on the timeline of a recorded session.
enum class MarkKind : std::uint8_t { joined, left, cut, taken_back, reset };
inline constexpr MarkKind last_mark = MarkKind::reset;

/// An event on the timeline of a recorded session, such as a cut: its tick, its kind, and the participant.
struct RecordingMark {
  std::uint64_t tick = 0;
  MarkKind kind = MarkKind::cut;
  std::string who;  // name of the participant that caused it; empty: none
};
inline constexpr std::size_t max_recording_marks = 1024;

/// Message from the server to all clients while a recording is played: its length and its events. Reliable,
/// transient-local. Ticks are those of SimTime.
struct Recording {
  std::uint64_t last_tick = 0;       // the first tick is 0
  std::vector<RecordingMark> marks;  // by tick, ascending
};

}  // namespace prosector
