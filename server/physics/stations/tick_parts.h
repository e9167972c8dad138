#pragma once
// Subdivision of a tick, for kinematic bodies so fast that they would pass through tissue.
//
// Contacts are linearised at the tick's start, with constant normals. A plate that moves farther than a
// surface cell in a tick would be beyond the tissue, or deep inside it, before a contact could determine the
// way out. So the whole tick is divided into equal parts, and contacts are found for each part. All bodies
// use the same parts, so coupled bodies stay in lockstep.

#include <span>
#include <utility>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/stations/touching/colliders.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Division of a tick into equal parts, for kinematic bodies (on prescribed trajectories) that move fast.
class TickParts {
 public:
  /// Determines the number of parts of the tick, such that no kinematic body moves farther in a part than the
  /// tissue in its path can follow. The number is 1 if no such body moves farther in the whole tick than a
  /// cell of that tissue's surface is wide. Updates `colliders` if needed.
  TickParts(State& state, Colliders& colliders);

  int count() const { return count_; }
  double h() const { return h_; }  // s, of each part
  /// Sets the targets of kinematic bodies and hands to their poses at the end of the tick's part k (from 0),
  /// interpolated over the whole tick.
  void aim(int k);
  /// Resets the hands' targets, which aim() replaced, to those of the whole tick. Merges the entries that
  /// each body has in `report`, one per part of the tick, into one.
  void finish(StepReport& report);

 private:
  struct Kinematic {
    std::size_t slot;
    Pose from, to;
  };
  void restart();

  State& state_;
  int count_;
  double h_;
  std::vector<Kinematic> kinematic_;
  std::vector<std::pair<Pose, Pose>> targets_;  // of hands, before and after the tick
};

}  // namespace prosector
