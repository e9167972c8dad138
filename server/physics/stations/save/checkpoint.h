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

/// Writes the state as it is. Adds the names of its values to `labels`.
void save(const State& state, ByteWriter& out, RecordLabels* labels = nullptr);

/// A saved state that was read and checked and is not yet in effect.
class RestoredState {
 public:
  /// Throws InputError for bytes that are no saved state of this scene. Does not change `state`, which must
  /// outlive this and stay as it is until take_effect().
  RestoredState(State& state, std::span<const std::uint8_t> bytes);
  /// Returns the number of soft bodies, pieces included.
  std::size_t soft_bodies() const { return soft_.size(); }
  const RestoredCuts& cuts() const { return cuts_; }
  /// Replaces the state. Call it once.
  void take_effect();

 private:
  void read(RecordReader& io);
  void read_hand(RecordReader& io, Hand& hand, const GraspableBodies& graspable);

  State& state_;
  RestoredCuts cuts_;
  RestoredRefinements refinements_;
  SimTime time_;
  RigidWorld rigid_;
  std::vector<SoftBodyState> soft_;
  std::vector<ContactMemories> memories_;
  std::vector<Hand> hands_;
  std::optional<PanelWorld> panels_;
  double room_lights_ = 1;
  LayerSides layer_sides_;
  std::vector<Part> parts_;
  std::map<BodyId, std::uint8_t> lost_;
  Entanglements entangled_;
  Lingerers::Map lingerers_;
};

/// Reads a saved state and puts it into effect. Throws InputError, and changes nothing, for bytes that are no
/// saved state of this scene.
void load(State& state, std::span<const std::uint8_t> bytes);
/// Returns a hash over every bit that changes the next tick.
std::uint64_t hash_of(const State& state);

}  // namespace prosector
