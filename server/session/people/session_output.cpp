#include "server/session/people/session_output.h"

namespace prosector {
namespace {

// Limits between two ticks.
constexpr std::size_t max_outgoing = 4096;
constexpr std::size_t max_events = 4096;

}  // namespace

void SessionOutput::answer(const Command& command, const Refusal& refusal) {
  if (outgoing_.size() >= max_outgoing)
    return drop("a reply to a command was discarded, because too many are waiting to be sent");
  CommandCount& count = commands_[command.body.index()];
  ++(refusal ? count.refused : count.granted);
  outgoing_.push_back({CommandResult{command.participant, command.sequence, !refusal, refusal.why()}});
}

void SessionOutput::tell(ParticipantId participant, const std::string& words) {
  if (outgoing_.size() >= max_outgoing)
    return drop("a message to a participant was discarded, because too many are waiting to be sent");
  outgoing_.push_back({CommandResult{participant, 0, false, words}});
}

void SessionOutput::log_if_room(SessionEvent event) {
  if (events_.size() < max_events) events_.push_back(std::move(event));
}

void SessionOutput::drop(const char* reason) {
  ++dropped_[reason];
  ++dropped_total_;
}

}  // namespace prosector
