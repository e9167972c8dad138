#include "server/session/pacing.h"

#include <fmt/format.h>

namespace prosector {

Refusal Pacing::obey(const Command& command, Role role) {
  if (role != Role::host) return "only the host stops, slows and steps time";
  if (command.kind == CommandKind::step_ticks) {
    if (command.revision < 1 || command.revision > most_steps)
      return fmt::format("steps: {} ticks; allowed are 1 to {}", command.revision, most_steps);
    pace_ = 0;
    steps_ = command.revision;
    return {};
  }
  if (command.value != 0 && (command.value < least_pace || command.value > most_))
    return fmt::format("pace: {:g} of real time; allowed are 0 and {:g} to {:g}", command.value, least_pace,
                       most_);
  pace_ = command.value;
  steps_ = 0;
  return {};
}

}  // namespace prosector
