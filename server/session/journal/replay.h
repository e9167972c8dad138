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
  /// The first value of the replayed state that differs from the journal's first checkpoint after the tick
  /// `first_difference`. None without such a checkpoint, or if the replayed state equals it.
  struct Value {
    std::uint64_t tick = 0;
    std::string name;  // "liver, positions"
  };
  std::optional<Value> differing_value;
  std::uint64_t last_hash = 0;
  explicit operator bool() const { return !first_difference; }
};

/// Throws InputError if `simulation` was not compiled from the same scene as the recorded one, as judged by
/// the hash of the compiled scene.
void require_same_scene(const JournalReader& journal, const Simulation& simulation);

/// Returns whether the topology changes that a step made are those that the journal recorded for it.
bool same_topology(const std::vector<TopologyRevision>& recorded, const std::vector<TopologyChange>& made);

/// Runs the journal's ticks after the simulation's current one with the recorded inputs, and compares the
/// state hash of each. Stops at the first difference, or continues to the next checkpoint to find which value
/// differs. `progress` is called with each tick that is equal; it may be empty.
ReplayResult replay(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(std::uint64_t tick)>& progress);

/// Restores the journal's newest undamaged checkpoint, and replays the recorded ticks after it, up to the
/// tick at which the session stopped. `say` is called with a message for each damaged checkpoint. Throws
/// InputError if a tick after the restored checkpoint is damaged.
ReplayResult resume(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(const std::string&)>& say);

}  // namespace prosector
