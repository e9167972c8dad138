#pragma once
// Checkpoints of what is refined.

#include <map>
#include <memory>
#include <vector>

#include "server/physics/base/record.h"
#include "server/physics/stations/save/saved_cuts.h"
#include "server/physics/world/state.h"

namespace prosector {

void save_refined(const State& state, RecordWriter& io);

/// Refinements restored from a checkpoint, before they replace those of the state. The state doesn't change
/// before take_effect().
class RestoredRefinements {
 public:
  /// Starts with nothing refined.
  explicit RestoredRefinements(State& state);
  /// Throws InputError for what doesn't fit.
  void read(RecordReader& io, const RestoredCuts& cuts);
  /// Puts the solvers of what is refined, or isn't any more, in the place of others in `bodies`, the soft
  /// bodies as RestoredCuts has them. Those are valid as long as this is.
  void replace(std::vector<const SoftBody*>& bodies);
  /// Gives the state these bodies; after the cuts.
  void take_effect();

 private:
  struct Restored {
    LocalRefinement mesh;
    bool touched = false;
    std::unique_ptr<SoftBody> solver;  // null: the one that is there is right
  };
  State& state_;
  std::map<std::size_t, Restored> refined_;  // by body: all that may be
};

}  // namespace prosector
