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

/// Local mesh refinements read from a checkpoint. They replace those of the state only in take_effect().
class RestoredRefinements {
 public:
  /// Starts with no refined mesh. `state` must outlive the object.
  explicit RestoredRefinements(State& state);
  /// Reads the local mesh refinements from a checkpoint, for bodies with the cuts `cuts`. Throws InputError
  /// for refinements that don't fit the scene.
  void read(RecordReader& io, const RestoredCuts& cuts);
  /// Replaces, in `bodies`, each soft body whose refinement in the checkpoint differs from its current one by
  /// a body with the checkpoint's mesh. `bodies` is the list that RestoredCuts::bodies() returns. The new
  /// pointers are valid as long as this object is.
  void replace(std::vector<const soft::SoftBody*>& bodies);
  /// Replaces the meshes of the state's refined bodies by those of the checkpoint. Must be called after
  /// RestoredCuts::take_effect().
  void take_effect();

 private:
  struct Restored {
    cutting::LocalRefinement mesh;
    bool touched = false;
    std::unique_ptr<soft::SoftBody> solver;  // null: the one that is there is right
  };
  State& state_;
  std::map<std::size_t, Restored> refined_;  // by body: all that may be
};

}  // namespace prosector
