#pragma once
// Combines the host's and the governor's settings of how exactly each soft body is solved. The less exact one
// applies.

#include <algorithm>
#include <map>

#include "server/physics/simulation.h"

namespace prosector {

class EffortDial {
 public:
  /// Stores the host's setting of how many steps a body's solver effort is reduced. Returns the setting that
  /// applies from now on: the larger reduction of host and governor.
  EffortChange host(const EffortChange& wanted) {
    steps_[wanted.body].host = wanted.steps_down;
    return counts(wanted.body);
  }
  /// Stores the setting of the governor (the load controller) of how many steps a body's solver effort is
  /// reduced. Returns the setting that applies from now on: the larger reduction of host and governor.
  EffortChange overload(const EffortChange& wanted) {
    steps_[wanted.body].overload = wanted.steps_down;
    return counts(wanted.body);
  }

 private:
  struct Steps {  // steps down
    int host = 0, overload = 0;
  };
  std::map<BodyId, Steps> steps_;

  EffortChange counts(BodyId body) const {
    const Steps& steps = steps_.at(body);
    return {body, std::max(steps.host, steps.overload)};
  }
};

}  // namespace prosector
