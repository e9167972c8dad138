#pragma once
// Runs a recorded session, and seeks to any of its ticks: it restores the nearest known state before the
// tick, and runs the journal's inputs from there. Every state hash is compared with the recorded one. The
// journal is only read.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "server/physics/simulation.h"
#include "server/session/journal/journal_reader.h"

namespace prosector {

class RecordingPlayer {
 public:
  // States of passed checkpoints are stored, so that a seek starts near its target. When they take more than
  // this, every second one is dropped.
  static constexpr std::size_t kept_budget = 256 * 1024 * 1024;  // bytes

  /// Prepares playback with a simulation at its beginning; both arguments outlive the player. Throws
  /// InputError when the simulation was not compiled from what the journal recorded.
  RecordingPlayer(const JournalReader& journal, Simulation& simulation);

  std::uint64_t tick() const { return simulation_.time().tick; }
  std::uint64_t last_tick() const { return last_tick_; }
  /// Returns whether the next tick can't be run: there is none, or the last one differs from the recorded
  /// one.
  bool at_end() const { return tick() >= last_tick_ || differs(); }
  /// Returns whether the present state is not the recorded one: another build or machine ran the recording.
  bool differs() const { return difference_.has_value(); }
  /// Returns the tick that differs.
  std::optional<std::uint64_t> difference() const { return difference_; }

  /// Returns whether playback went back to the beginning and has met no known state since. A scene's first
  /// ticks run on caches from its compilation. After a restore the last bits may differ, so hashes are not
  /// compared.
  bool is_near_enough() const { return near_enough_; }

  /// Runs the next tick. Throws InputError when it can't be read.
  const StepReport& step();
  /// Restores the known state that is nearest before `tick`, unless the present state is nearer. The caller
  /// runs the remaining ticks.
  void approach(std::uint64_t tick);

 private:
  using State = std::vector<std::uint8_t>;
  const JournalReader& journal_;
  Simulation& simulation_;
  std::uint64_t last_tick_;
  std::set<std::uint64_t> checkpoints_;  // of the journal
  State beginning_;
  std::map<std::uint64_t, State> kept_;
  std::size_t kept_bytes_ = 0;
  std::optional<std::uint64_t> difference_;
  bool near_enough_ = false;

  bool meet_known_state();
  void keep(State state);
  State state_before(std::uint64_t tick);
};

}  // namespace prosector
