#pragma once
// What a journal keeps of a tick and of a checkpoint, and the seals that prove it: hashes over all that the
// file says of it. A row whose seal does not fit is damaged, or of another journal.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "server/session/session.h"

namespace prosector {

// The ticks between checkpoints. The run that goes on and one restored from a checkpoint are equal from the
// checkpoint on. So checkpoints are part of the run's bits: always at these ticks, journal or not.
inline constexpr std::uint64_t checkpoint_ticks = 600;

struct JournalTick {
  std::uint64_t tick = 0;
  ConsumedInput input;
  std::uint64_t state_hash = 0;  // after the step, and after the caches were rebuilt
  bool rebuilt = false;          // the step's caches were rebuilt after it, as a restored run's are
  std::vector<SessionEvent> events;
  std::vector<TopologyRevision> topology;  // that the step made; without patches
};

/// Returns the seal of a row. `journal` is the seal of the file's description: rows of another journal don't
/// fit.
std::uint64_t seal_of(std::uint64_t journal, const JournalTick& tick,
                      std::span<const std::uint8_t> input_bytes);
std::uint64_t seal_of_checkpoint(std::uint64_t journal, std::uint64_t tick,
                                 std::span<const std::uint8_t> state);
/// Returns the seal of the file's description, key by key, in their order.
std::uint64_t seal_of(std::span<const std::pair<std::string, std::string>> description);

/// Returns how an event's kind is written.
std::string event_name(SessionEvent::Kind kind);
/// Returns the kind of that name; nothing when it is no name of one.
std::optional<SessionEvent::Kind> event_kind(const std::string& name);

}  // namespace prosector
