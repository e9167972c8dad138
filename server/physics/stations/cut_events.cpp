#include "server/physics/stations/cut_events.h"

#include "server/physics/stations/dissecting/cut_by_blades.h"
#include "server/physics/stations/save/rewind.h"

namespace prosector {

bool apply_cut_events(State& state, std::span<const CutEvent> events, StepReport& report) {
  bool went_back = false;
  for (const CutEvent& event : events) {
    const bool rewinds = event.kind == CutEvent::Kind::rewind;
    const Refusal& answer = report.cut_answers.emplace_back(
        rewinds ? rewind(state, event, report) : undo_last_cut(state, event.participant, report));
    went_back |= rewinds && !answer;
  }
  return went_back;
}

}  // namespace prosector
