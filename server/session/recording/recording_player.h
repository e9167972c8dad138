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

  /// Prepares playback of the journal with a simulation that is at the recording's first state. Both
  /// arguments must outlive the player. Throws InputError if the simulation was not compiled from the
  /// recorded scene.
  RecordingPlayer(const JournalReader& journal, Simulation& simulation);

  std::uint64_t tick() const { return simulation_.time().tick; }
  std::uint64_t last_tick() const { return last_tick_; }
  /// Returns whether playback can't continue: the recording has no further tick, or the current state differs
  /// from the recorded one.
  bool at_end() const { return tick() >= last_tick_ || differs(); }
  /// Returns whether the current state is not the recorded one, because another build or machine recorded the
  /// session.
  bool differs() const { return difference_.has_value(); }
  /// Returns the first tick after which the state differs from the recorded one. Returns nullopt if there is
  /// none.
  std::optional<std::uint64_t> difference() const { return difference_; }

  /// Returns whether playback went back to the beginning and has not reached a stored state or checkpoint
  /// since. A scene's first ticks run on caches from its compilation. After a restore the last bits may
  /// differ, so hashes are not compared.
  bool is_near_enough() const { return near_enough_; }

  /// Runs the next recorded tick and returns its report. Throws InputError if the tick can't be read from the
  /// journal.
  const StepReport& step();
  /// Restores the stored state or checkpoint that is nearest before `tick`, unless the current state is
  /// nearer. The caller runs the remaining ticks up to `tick`.
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
