#pragma once
// Writes the ticks of a live session to its journal, if it has one, and decides when to make checkpoints.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "common/rate_limited_flag.h"
#include "server/physics/simulation.h"
#include "server/session/journal/journal.h"

namespace prosector {

class TickJournal {
 public:
  using State = std::vector<std::uint8_t>;
  /// Functions that the journal calls. `say` gets lines of the session's log. `checkpoint` makes a checkpoint
  /// and throws InputError where it can't be restored; null: Simulation::checkpoint().
  struct Hooks {
    std::function<void(const std::string&)> say;
    std::function<State()> checkpoint;
  };

  /// Stores references: the simulation and the journal must outlive the object. `journal` may be null: the
  /// session is not recorded.
  TickJournal(Simulation& simulation, Journal* journal, Hooks hooks);

  /// Returns whether the session has a journal.
  bool exists() const { return journal_ != nullptr; }
  /// Makes a checkpoint at the regular ticks. With a journal, also makes one when the ticks since the last
  /// one would take long to run again. Returns nothing if none is due, or if it can't be restored.
  State checkpoint_if_due();
  /// Returns a checkpoint, or nothing if its own bytes can't be restored. Then the session continues from its
  /// present state, and the journal from its last checkpoint.
  State checkpoint();
  /// Queues a tick and its checkpoint (empty: it has none) to be written. Sets `tick.rebuilt`.
  void append(JournalTick tick, State checkpoint);
  /// Adds the duration of a tick to that of a replay since the last checkpoint.
  void add_duration(std::int64_t ns) { since_checkpoint_ns_ += ns; }
  /// Waits for the journal: a tick is in the file before users see it, unless the disk is too slow for that.
  /// Reports delays and failures to the log. `now` is in seconds on a monotonic clock.
  void settle(double now);

  /// Returns, as text for the server's status, whether the journal is late or has stopped. Empty: neither.
  std::string complaint() const;
  /// Returns the number of checkpoints that can't be restored.
  std::uint64_t refused_checkpoints() const { return refused_checkpoints_; }

 private:
  Simulation& simulation_;
  Journal* journal_;
  Hooks hooks_;
  std::int64_t since_checkpoint_ns_ = 0;
  std::uint64_t refused_checkpoints_ = 0;
  std::string error_;
  bool late_ = false;
  RateLimitedFlag lateness_;
};

}  // namespace prosector
