#pragma once
// The time of a played recording as clients see it. Its epoch rises with each jump, as after a rewind of a
// live session.

#include <cstdint>

#include "common/ids.h"

namespace prosector {

class DisplayedTime {
 public:
  /// Returns the time that clients see when the simulation's time is `simulated`.
  SimTime of(SimTime simulated) const {
    simulated.epoch += shift_;
    return simulated;
  }
  /// Records that clients last see the simulation's time `simulated` before a jump that may follow.
  void leave(SimTime simulated) { left_ = of(simulated).epoch; }
  /// Records that a jump ended at the simulation's time `simulated`. From now on, clients see a later epoch
  /// than that of the last leave().
  void arrive(SimTime simulated) { shift_ = left_ + 1 - simulated.epoch; }

 private:
  std::uint32_t shift_ = 0;  // added to the simulation's epoch
  std::uint32_t left_ = 0;   // seen before the jump
};

}  // namespace prosector
