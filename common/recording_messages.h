#pragma once
// Messages about a recording that is played back.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace prosector {

/// Kind of an event in a recorded session.
enum class MarkKind : std::uint8_t { joined, left, cut, taken_back, reset };
inline constexpr MarkKind last_mark = MarkKind::reset;

/// An event in a recorded session.
struct RecordingMark {
  std::uint64_t tick = 0;
  MarkKind kind = MarkKind::cut;
  std::string who;  // name of the participant that caused it; empty: none
};
inline constexpr std::size_t max_recording_marks = 1024;

/// server → all, reliable, transient-local: sent while a recording is played. Its ticks are those of SimTime.
struct Recording {
  std::uint64_t last_tick = 0;       // the first tick is 0
  std::vector<RecordingMark> marks;  // by tick, ascending
};

}  // namespace prosector
