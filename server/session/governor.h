#pragma once
// Decides, from how long ticks took by the clock on the wall, which bodies are solved less exactly. It stands
// outside the step: what it decides is an input of the next tick and journalled with it, so that a replay,
// which measures nothing, repeats it.
//
// Overload is a window of ticks of which more than half were longer than their period: of the bodies that
// may, the one that costs most goes one step down. Room is enough ticks that took at most room_share of the
// period, each other tick undoing ten of them: the body that stepped down last goes one step up. Who stepped
// up in vain, because overload followed, waits twice as long the next time.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

class Governor {
 public:
  static constexpr double overload_seconds = 0.5;  // of ticks that are judged together
  static constexpr double room_seconds = 2;        // of ticks with room before a step up
  static constexpr double room_share = 0.6;
  static constexpr double vain_seconds = 5;       // overload so soon after a step up: it was in vain
  static constexpr double longest_patience = 60;  // s: of ticks with room before a step up, at most

  /// Takes the bodies whose scene allows stepping down, and by how much each is stepped down already.
  Governor(double tick_rate, std::map<BodyId, int> may);

  /// Takes that one tick took `seconds`, and each body `work` (in any unit that is common to them; asleep or
  /// missing: none). Returns what the next tick changes.
  std::optional<EffortChange> tick(double seconds, const std::map<BodyId, double>& work);

  const std::map<BodyId, int>& steps_down() const { return steps_; }

 private:
  double period_, patience_ = room_seconds;
  std::map<BodyId, int> steps_;
  std::vector<BodyId> order_;  // who stepped down, one entry a step
  int late_ = 0, judged_ = 0, room_ = 0;
  std::uint64_t tick_ = 0;
  std::optional<std::uint64_t> stepped_up_at_;

  std::optional<EffortChange> step_down(const std::map<BodyId, double>& work);
  std::optional<EffortChange> step_up();
  EffortChange change(BodyId body, int by);
  int ticks(double seconds) const;
};

}  // namespace prosector
