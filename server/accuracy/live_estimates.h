#pragma once
// Estimates of the error of each soft body of a running simulation, repeated while it runs. After each tick
// some pieces of work are done, one body after another. They read the state and change nothing in it.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "server/accuracy/body_estimator.h"
#include "server/accuracy/error_grid.h"
#include "server/physics/simulation.h"

namespace prosector {

/// The newest estimate of the error of one soft body: total, parts, error of the pressing force, and error
/// map.
struct LiveEstimate {
  std::uint64_t tick = 0;  // tick of the estimated state
  double error = -1;       // as in BodyStatus; 0 where the body moved by less than the precision of its shape
  ErrorParts parts;
  double press_error = -1;
  double press_force = 0;  // N: force with which hands press the body
  ErrorMap map;
};

class LiveEstimates {
 public:
  explicit LiveEstimates(const Simulation& simulation);

  /// Continues the error estimates of soft bodies after a tick. The number of pieces of work depends on the
  /// bodies alone, not on a clock. Awake bodies are estimated each quarter of a second. A body that was cut
  /// or detached is estimated once it has not changed for half a second.
  void follow(const Simulation& simulation, const StepReport& report);
  /// Returns the newest error estimate of a body. Returns null if there is none, or if it is no longer valid
  /// because the body was cut, detached or attached since.
  const LiveEstimate* newest(BodyId body) const;

 private:
  struct Body {
    std::unique_ptr<BodyEstimator> estimator;  // null: the body can't be estimated
    std::unique_ptr<ErrorGrid> grid;
    std::uint32_t revision = 0;
    bool attached = true;
    std::uint64_t changed = 0;  // tick of the last cut, attachment or detachment
    bool rebuild = true;
    bool settled = false;     // estimated since it fell asleep
    VecX v, v_before;         // 3n, m/s: after the previous tick, and the one before that
    int ticks = 0;            // how many consecutive ticks v and v_before are of: 0, 1, 2
    double solver = 0;        // m: position error of the nodes from the last solve
    double pressed = -1;      // N: force of hands when the estimate began; below 0: none touched it
    bool was_asleep = false;  // when the estimate began
    bool stirred = false;     // then: displaced by more than the precision of its shape
    std::uint64_t begun = 0;
    std::optional<LiveEstimate> newest;
  };

  void watch(const Simulation& simulation, BodyId id, Body& body);
  void rebuild(const Simulation& simulation, BodyId id, Body& body);
  bool due(const Simulation& simulation, BodyId id, const Body& body) const;
  void begin(const Simulation& simulation, BodyId id, Body& body);
  static void take(Body& body);
  void remember(const Simulation& simulation, BodyId id, Body& body);

  double h_;            // s: length of a tick
  std::uint64_t turn_;  // ticks in which all due bodies are estimated
  std::map<BodyId, Body> bodies_;
  std::optional<BodyId> at_;  // the body being estimated
  BodyId last_ = 0;           // the body estimated last
  BodyMoment moment_;         // buffers
};

}  // namespace prosector
