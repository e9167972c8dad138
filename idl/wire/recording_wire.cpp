// Wire conversion of the description of a recording: Recording.

#include "idl/wire/fields.h"

namespace prosector {
namespace {

template <class Io>
void fields(Io& io, MessageOf<Io, RecordingMark>& m, WireOf<Io, prosector_RecordingMark>& w) {
  io(m.tick, w.tick);
  io(m.kind, w.kind);
  io(m.who, w.who);
}

template <class Io>
void fields(Io& io, MessageOf<Io, Recording>& m, WireOf<Io, prosector_Recording>& w) {
  io(m.last_tick, w.last_tick);
  io.list(m.marks, w.marks, max_recording_marks, "too many marks",
          [](auto& items, auto& mark, auto& field) { fields(items, mark, field); });
}

}  // namespace

PROSECTOR_WIRE_BY_FIELDS(Recording);

Refusal check(Recording& m) {
  Checks checks;
  checks.that(m.marks.size() <= max_recording_marks, "too many marks");
  std::uint64_t last = 0;
  for (const RecordingMark& mark : m.marks) {
    checks.that(mark.tick >= last, "marks out of order")
        .that(mark.tick <= m.last_tick, "a mark of the recording is after its end")
        .that(enum_within(mark.kind, last_mark), "unknown kind of mark")
        .that(mark.who.empty() || valid_name(mark.who), "name not valid");
    last = mark.tick;
  }
  return checks.refusal();
}

}  // namespace prosector
