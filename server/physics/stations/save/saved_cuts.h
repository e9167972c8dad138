#pragma once
// Checkpoints of what was cut: organs' logs, which are gone through again, and blades that hands hold.

#include <map>
#include <memory>
#include <vector>

#include "server/physics/base/record.h"
#include "server/physics/world/state.h"

namespace prosector {

void save_cuts(const State& state, RecordWriter& io);

/// Cut organs and blades read from a checkpoint. They replace those of the state only in take_effect().
class RestoredCuts {
 public:
  /// Starts with no cuts. `state` must outlive the object.
  explicit RestoredCuts(State& state);
  /// Reads the cuts from a checkpoint. Throws InputError for cuts that don't fit the scene.
  void read(RecordReader& io);
  bool is_cut(std::size_t body) const { return organs_.contains(body); }
  /// Returns the cut organs of the checkpoint, by the index of the soft body that each was originally.
  const std::map<std::size_t, organs::Organ>& organs() const { return organs_; }
  /// Returns the soft bodies with the checkpoint's cuts, including all pieces, by index. The pointers are
  /// valid as long as this object and the state are.
  std::vector<const soft::SoftBody*> bodies() const;
  /// Replaces the state's soft bodies, organs and the blades that hands hold by those of the checkpoint.
  void take_effect();

 private:
  struct Piece {
    std::size_t first = 0;                   // of its organ
    std::unique_ptr<soft::SoftBody> solver;  // null: the state's own is right
    Numbering numbering;
    std::uint32_t revision = 0;
    VecX equilibrium;
  };
  void read_organ(RecordReader& io, std::size_t first);
  bool is_current(std::size_t first, const organs::Organ& organ) const;

  State& state_;
  std::size_t count_;  // soft bodies
  std::map<std::size_t, organs::Organ> organs_;
  std::map<std::size_t, Piece> pieces_;  // by body
  std::vector<organs::Blade> blades_;
  std::uint64_t strokes_ = 0;
};

}  // namespace prosector
