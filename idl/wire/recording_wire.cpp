// Wire conversion of the description of a recording: Recording.

#include "idl/wire/primitives.h"

namespace prosector {

void to_wire(const Recording& m, prosector_Recording& w, WireArena& arena) {
  w.last_tick = m.last_tick;
  make_sequence<prosector_RecordingMark>(w.marks, m.marks.size(), arena);
  for (std::size_t i = 0; i < m.marks.size(); ++i) {
    prosector_RecordingMark& mark = w.marks._buffer[i];
    mark.tick = m.marks[i].tick;
    mark.kind = static_cast<std::uint8_t>(m.marks[i].kind);
    to_wire(m.marks[i].who, mark.who);
  }
}

Refusal from_wire(const prosector_Recording& w, Recording& m) {
  if (!sequence_within(w.marks, max_recording_marks)) return "too many marks";
  m.last_tick = w.last_tick;
  m.marks.clear();
  for (std::size_t i = 0; i < w.marks._length; ++i) {
    const prosector_RecordingMark& mark = w.marks._buffer[i];
    m.marks.push_back({mark.tick, static_cast<MarkKind>(mark.kind), from_wire(mark.who)});
  }
  return {};
}

Refusal check(Recording& m) {
  Checks checks;
  checks.that(m.marks.size() <= max_recording_marks, "too many marks");
  std::uint64_t last = 0;
  for (const RecordingMark& mark : m.marks) {
    checks.that(mark.tick >= last, "marks out of order")
        .that(mark.tick <= m.last_tick, "a mark beyond the end")
        .that(enum_within(mark.kind, last_mark), "unknown kind of mark")
        .that(mark.who.empty() || valid_name(mark.who), "name not valid");
    last = mark.tick;
  }
  return checks.refusal();
}

}  // namespace prosector
