#pragma once
// Runs a journal's ticks again and compares every state hash.

#include <cstdint>
#include <functional>
#include <optional>

#include "server/physics/simulation.h"
#include "server/session/journal_reader.h"

namespace prosector {

struct ReplayResult {
  std::uint64_t ticks = 0;  // run again and equal
  std::optional<std::uint64_t> first_difference;
  std::uint64_t last_hash = 0;
  explicit operator bool() const { return !first_difference; }
};

/// Throws InputError when `simulation` was not compiled from what the journal recorded.
void require_same_scene(const JournalReader& journal, const Simulation& simulation);

/// Tells whether a step made the revisions that a journal says.
bool same_topology(const std::vector<TopologyRevision>& recorded, const std::vector<TopologyChange>& made);

/// Runs what was journalled. `simulation` stands at the tick before the first one to run. Stops at the first
/// difference. `progress` hears of each tick done; may be empty.
ReplayResult replay(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(std::uint64_t tick)>& progress);

/// Restores the newest checkpoint that is whole and runs what was journalled after it: where the session
/// stopped. `say` hears of each damaged checkpoint. Throws InputError when a tick after it is damaged.
ReplayResult resume(const JournalReader& journal, Simulation& simulation,
                    const std::function<void(const std::string&)>& say);

}  // namespace prosector
