#pragma once
// How exactly each soft body is solved: as the host wants it, but no more exactly than overload allows.

#include <algorithm>
#include <map>

#include "server/physics/simulation.h"

namespace prosector {

class EffortDial {
 public:
  /// Takes what the host wants of a body; returns what counts from now on.
  EffortChange host(const EffortChange& wanted) {
    steps_[wanted.body].host = wanted.steps_down;
    return counts(wanted.body);
  }
  /// Takes what the governor wants of a body; returns what counts from now on.
  EffortChange overload(const EffortChange& wanted) {
    steps_[wanted.body].overload = wanted.steps_down;
    return counts(wanted.body);
  }

 private:
  struct Steps {  // down
    int host = 0, overload = 0;
  };
  std::map<BodyId, Steps> steps_;

  EffortChange counts(BodyId body) const {
    const Steps& steps = steps_.at(body);
    return {body, std::max(steps.host, steps.overload)};
  }
};

}  // namespace prosector
