#pragma once
// Rows of a journal for ticks and checkpoints, and their seals: hashes over all of a row's data. A row whose
// seal does not match is damaged, or from another journal.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/session/people/session.h"

namespace prosector {

// Number of ticks between regular checkpoints. The run that goes on and one restored from a checkpoint are
// equal from the checkpoint on. So checkpoints affect the results of the run, and are always made at these
// ticks, with or without a journal.
inline constexpr std::uint64_t checkpoint_ticks = 600;

struct JournalTick {
  std::uint64_t tick = 0;
  ConsumedInput input;
  std::uint64_t state_hash = 0;  // after the step, and after the caches were rebuilt
  bool rebuilt = false;          // the caches were rebuilt after the step, as in a restored run
  std::vector<SessionEvent> events;
  std::vector<TopologyRevision> topology;  // revisions that the step made; without patches
};

/// Returns the seal (hash) of a journal's row for a tick. `journal` is the seal of the file's description, so
/// that rows of another journal don't match.
std::uint64_t seal_of(std::uint64_t journal, const JournalTick& tick,
                      std::span<const std::uint8_t> input_bytes);
std::uint64_t seal_of_checkpoint(std::uint64_t journal, std::uint64_t tick,
                                 std::span<const std::uint8_t> state);
/// Returns the seal (hash) of the keys and values that describe a journal, in order.
std::uint64_t seal_of(std::span<const std::pair<std::string, std::string>> description);

/// Returns the name under which the journal stores events of that kind.
std::string event_name(SessionEvent::Kind kind);
/// Returns the kind of event that the journal stores under that name. Returns nothing if there is none.
std::optional<SessionEvent::Kind> event_kind(const std::string& name);

}  // namespace prosector
