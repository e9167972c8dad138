#pragma once
// Checkpoints. Loading rebuilds the rigid world from plain numbers, so that Bullet's caches depend on them
// only. A run that continues after a checkpoint and one that restores it are equal.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/byte_stream.h"
#include "server/physics/stations/save/saved_cuts.h"
#include "server/physics/stations/save/saved_refinements.h"
#include "server/physics/world/state.h"

namespace prosector {

struct GraspableBodies;

/// Appends the state's saved form to `out`, without changing the state. Adds the names of the saved values
/// and their offsets to `labels`, unless that is null.
void save(const State& state, ByteWriter& out, RecordLabels* labels = nullptr);

/// A saved simulation state that was read and checked but has not replaced the current state yet.
class RestoredState {
 public:
  /// Reads and checks a saved state. Throws InputError for bytes that are no saved state of this scene.
  /// `state` is not changed. It must outlive this object and must not change until take_effect().
  RestoredState(State& state, std::span<const std::uint8_t> bytes);
  /// Returns the number of soft bodies in the saved state, including pieces that were cut off.
  std::size_t soft_bodies() const { return soft_.size(); }
  const RestoredCuts& cuts() const { return cuts_; }
  /// Replaces the current state by the saved one. The function must be called at most once.
  void take_effect();

 private:
  void read(RecordReader& io);
  void read_hand(RecordReader& io, hands::Hand& hand, const GraspableBodies& graspable);

  State& state_;
  RestoredCuts cuts_;
  RestoredRefinements refinements_;
  SimTime time_;
  rigid::RigidWorld rigid_;
  std::vector<soft::SoftBodyState> soft_;
  std::vector<contact::ContactMemories> memories_;
  std::vector<hands::Hand> hands_;
  std::optional<panel::PanelWorld> panels_;
  double room_lights_ = 1;
  LayerSides layer_sides_;
  std::vector<Part> parts_;
  std::map<BodyId, std::uint8_t> lost_;
  Entanglements entangled_;
  coupled::Lingerers::Map lingerers_;
};

/// Reads a saved state and replaces `state` by it. Throws InputError, and changes nothing, for bytes that are
/// no saved state of this scene.
void load(State& state, std::span<const std::uint8_t> bytes);
/// Returns a hash of every bit of the state that affects the next tick.
std::uint64_t hash_of(const State& state);

}  // namespace prosector
