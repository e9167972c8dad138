#pragma once
// Decides from the wall-clock time of ticks which bodies are solved less exactly. It runs outside the step.
// Its decisions are inputs of the next tick and journalled with it, so that a replay, which measures nothing,
// repeats them.
//
// Overload is a window of ticks of which more than half took longer than their period. Then, of the bodies
// that may step down, the one that costs most goes one step down. There is room when enough ticks took at
// most room_share of the period, where each other tick cancels ten of them. Then the body that stepped down
// last goes one step up. If overload follows soon, the step up was in vain, and the next one waits twice as
// long.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

class Governor {
 public:
  static constexpr double overload_seconds = 0.5;  // s: window of ticks that are judged together
  static constexpr double room_seconds = 2;        // s: ticks with room before a step up
  static constexpr double room_share = 0.6;
  static constexpr double vain_seconds = 5;        // s: overload this soon after a step up: it was in vain
  static constexpr double max_step_up_delay = 60;  // s: most ticks with room before a step up

  /// Starts with the bodies whose solver effort the scene allows to reduce. `may` has, by body, the number of
  /// steps by which it is reduced already.
  Governor(double tick_rate, std::map<BodyId, int> may);

  /// Processes the duration of a tick. It took `seconds`, of which each body took a share in proportion to
  /// `work`; bodies that are missing there were asleep. Returns a change of a body's solver effort for the
  /// next tick, or nothing.
  std::optional<EffortChange> tick(double seconds, const std::map<BodyId, double>& work);

  const std::map<BodyId, int>& steps_down() const { return steps_; }

 private:
  double period_, step_up_delay_ = room_seconds;
  std::map<BodyId, int> steps_;
  std::vector<BodyId> order_;  // bodies that stepped down, one entry per step
  int late_ = 0, judged_ = 0, room_ = 0;
  std::uint64_t tick_ = 0;
  std::optional<std::uint64_t> stepped_up_at_;

  std::optional<EffortChange> step_down(const std::map<BodyId, double>& work);
  std::optional<EffortChange> step_up();
  EffortChange change(BodyId body, int by);
  int ticks(double seconds) const;
};

}  // namespace prosector
