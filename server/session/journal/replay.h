#pragma once
// Runs a journal's ticks again and compares every state hash.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "server/physics/simulation.h"
#include "server/session/journal/journal_reader.h"

namespace prosector {

struct ReplayResult {
  std::uint64_t ticks = 0;  // run again and equal
  std::optional<std::uint64_t> first_difference;
  /// The first value that differs at the first checkpoint from there on; none: the journal has none, or they
  /// are equal there.
  struct Value {
    std::uint64_t tick = 0;
    std::string name;  // "liver, positions"
  };
  std::optional<Value> differing_value;
  std::uint64_t last_hash = 0;
  explicit operator bool() const { return !first_difference; }
};

/// Throws InputError when `simulation` was not compiled from what the journal recorded.
void require_same_scene(const JournalReader& journal, const Simulation& simulation);

/// Returns whether a step made the revisions that a journal says.
bool same_topology(const std::vector<TopologyRevision>& recorded, const std::vector<TopologyChange>& made);

/// Runs what was journalled. `simulation` is at the tick before the first one to run. Stops at the first
/// difference, or goes on to the next checkpoint to find which value differs. `progress` is called with each
/// equal tick; may be empty.
ReplayResult replay(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(std::uint64_t tick)>& progress);

/// Restores the newest checkpoint that is whole and runs what was journalled after it: where the session
/// stopped. `say` hears of each damaged checkpoint. Throws InputError when a tick after it is damaged.
ReplayResult resume(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(const std::string&)>& say);

}  // namespace prosector
