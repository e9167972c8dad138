#include "server/physics/stations/cut_events.h"

#include "server/physics/stations/dissecting/cut_by_blades.h"
#include "server/physics/stations/save/rewind.h"

namespace prosector {

bool apply_cut_events(State& state, std::span<const CutEvent> events, StepReport& report) {
  bool rewound = false;
  for (const CutEvent& event : events) {
    const bool rewinds = event.kind == CutEvent::Kind::rewind;
    const Refusal& answer = report.cut_answers.emplace_back(
        rewinds ? rewind(state, event, report) : undo_last_cut(state, event.participant, report));
    rewound |= rewinds && !answer;
  }
  return rewound;
}

}  // namespace prosector
