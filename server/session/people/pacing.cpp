#include "server/session/people/pacing.h"

#include <fmt/format.h>

namespace prosector {

Refusal Pacing::obey(const SetPace& command) {
  if (command.pace != 0 && (command.pace < min_pace || command.pace > most_))
    return fmt::format("pace: {:g} times real time was requested; allowed: 0 (stopped), or {:g} to {:g}",
                       command.pace, min_pace, most_);
  set(command.pace);
  return {};
}

Refusal Pacing::obey(const StepTicks& command) {
  if (command.ticks < 1 || command.ticks > most_steps)
    return fmt::format("steps: {} ticks; allowed: 1 to {}", command.ticks, most_steps);
  pace_ = 0;
  steps_ = command.ticks;
  return {};
}

}  // namespace prosector
