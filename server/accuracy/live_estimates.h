#pragma once
// Estimates of what is wrong with each soft body of a running simulation, found anew while it runs: some
// pieces of work after each tick, one body after another. They are read from the state and change nothing in
// it.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "server/accuracy/body_estimator.h"
#include "server/accuracy/error_grid.h"
#include "server/physics/simulation.h"

namespace prosector {

/// What is told of one body.
struct LiveEstimate {
  std::uint64_t tick = 0;  // of the state that it is of
  double error = -1;       // as of BodyStatus; 0 where the body moved by less than is told of it
  ErrorParts parts;
  double press_error = -1;
  double press_force = 0;  // N: with which hands press it
  ErrorMap map;
};

class LiveEstimates {
 public:
  explicit LiveEstimates(const Simulation& simulation);

  /// Goes on after a tick. The pieces of work depend on the bodies alone, on no clock. What is awake is
  /// looked at anew each quarter of a second. What was cut or untied is looked at once it has been as it is
  /// for half a second.
  void follow(const Simulation& simulation, const StepReport& report);
  /// Returns what is known of a body; null: nothing, or not any more.
  const LiveEstimate* newest(BodyId body) const;

 private:
  struct Body {
    std::unique_ptr<BodyEstimator> estimator;  // null: it can't be judged
    std::unique_ptr<ErrorGrid> grid;
    std::uint32_t revision = 0;
    bool attached = true;
    std::uint64_t changed = 0;  // the tick since when it is as it is
    bool rebuild = true;
    bool settled = false;     // judged since it fell asleep
    VecX v, v_before;         // 3n, m/s: after the tick before, and the one before that
    int ticks = 0;            // of v in a row: 0, 1, 2
    double solver = 0;        // m: how far the last solve left nodes wrong
    double pressed = -1;      // N: by hands, when the estimate began; below 0: none touched it
    bool was_asleep = false;  // when the estimate began
    bool stirred = false;     // then: moved by more than is told of positions
    std::uint64_t begun = 0;
    std::optional<LiveEstimate> newest;
  };

  void watch(const Simulation& simulation, BodyId id, Body& body);
  void rebuild(const Simulation& simulation, BodyId id, Body& body);
  bool due(const Simulation& simulation, BodyId id, const Body& body) const;
  void begin(const Simulation& simulation, BodyId id, Body& body);
  static void take(Body& body);
  void remember(const Simulation& simulation, BodyId id, Body& body);

  double h_;            // s: of a tick
  std::uint64_t turn_;  // ticks in which all that is due is looked at
  std::map<BodyId, Body> bodies_;
  std::optional<BodyId> at_;  // whose turn it is
  BodyId last_ = 0;           // whose it was
  BodyMoment moment_;         // buffers
};

}  // namespace prosector
