#include "server/session/people/scene_requests.h"

#include <algorithm>

namespace prosector {

void SceneRequests::consume(Seat& seat, TickInput& out) {
  for (const PendingPart& part : seat.parts) {
    out.parts.push_back(part.event);
    stepping_.push_back(part.command);
  }
  seat.parts.clear();
  for (const PendingCut& cut : seat.cuts) {
    out.cuts.push_back(cut.event);
    cutting_.push_back(cut);
  }
  seat.cuts.clear();
}

void SceneRequests::finish_tick(const StepReport& report, const Roster& roster, SessionOutput& output) {
  for (std::size_t i = 0; i < std::min(stepping_.size(), report.part_answers.size()); ++i)
    output.answer(stepping_[i], report.part_answers[i]);
  stepping_.clear();
  for (std::size_t i = 0; i < cutting_.size(); ++i) {
    const auto& [command, event, rewinds_to] = cutting_[i];
    const Refusal refusal =
        i < report.cut_answers.size() ? report.cut_answers[i] : Refusal("nothing has been cut");
    output.answer(command, refusal);
    const auto member = roster.members().find(command.participant);
    if (!rewinds_to.empty() && !refusal && member != roster.members().end())
      output.log(
          {SessionEvent::Kind::rewound, command.participant, member->second.presence.name, rewinds_to});
  }
  cutting_.clear();
}

}  // namespace prosector
