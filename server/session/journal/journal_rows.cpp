#include "server/session/journal/journal_rows.h"

#include <algorithm>
#include <array>

#include "common/assert.h"
#include "common/hash.h"

namespace prosector {
namespace {

using Kind = SessionEvent::Kind;
constexpr std::array<std::pair<Kind, const char*>, 13> event_names = {{{Kind::joined, "joined"},
                                                                       {Kind::refused, "refused"},
                                                                       {Kind::left, "left"},
                                                                       {Kind::lost, "lost"},
                                                                       {Kind::hand_timeout, "hand timeout"},
                                                                       {Kind::role, "role"},
                                                                       {Kind::let_go, "let go"},
                                                                       {Kind::broke, "broke"},
                                                                       {Kind::rewound, "rewound"},
                                                                       {Kind::pace, "pace"},
                                                                       {Kind::effort, "effort"},
                                                                       {Kind::accuracy, "accuracy"},
                                                                       {Kind::hand_stalled, "hand stalled"}}};

void add(StateHasher& hasher, std::span<const std::uint8_t> bytes) {
  hasher.add(std::uint64_t{bytes.size()});
  hasher.add(std::as_bytes(bytes));
}

void add(StateHasher& hasher, const std::string& text) {
  hasher.add(std::uint64_t{text.size()});
  hasher.add(std::as_bytes(std::span(text)));
}

void add(StateHasher& hasher, const SessionEvent& e) {
  hasher.add(e.kind);
  hasher.add(e.participant);
  add(hasher, e.name);
  add(hasher, e.detail);
}

void add(StateHasher& hasher, const TopologyRevision& r) {
  hasher.add(r.body);
  hasher.add(r.revision);
  hasher.add(r.cause);
  hasher.add(r.author);
  hasher.add(r.piece_of);
  hasher.add(r.content_hash);
  hasher.add(r.surface_hash);
  hasher.add(r.chain_hash);
}

}  // namespace

std::uint64_t seal_of(std::uint64_t journal, const JournalTick& tick,
                      std::span<const std::uint8_t> input_bytes) {
  StateHasher hasher;
  hasher.add(journal);
  hasher.add(tick.tick);
  hasher.add(tick.state_hash);
  hasher.add(std::uint8_t{tick.rebuilt});
  add(hasher, input_bytes);
  hasher.add(std::uint64_t{tick.events.size()});
  for (const SessionEvent& e : tick.events) add(hasher, e);
  hasher.add(std::uint64_t{tick.topology.size()});
  for (const TopologyRevision& r : tick.topology) add(hasher, r);
  return hasher.digest();
}

std::uint64_t seal_of_checkpoint(std::uint64_t journal, std::uint64_t tick,
                                 std::span<const std::uint8_t> state) {
  StateHasher hasher;
  hasher.add(journal);
  hasher.add(tick);
  add(hasher, state);
  return hasher.digest();
}

std::uint64_t seal_of(std::span<const std::pair<std::string, std::string>> description) {
  StateHasher hasher;
  for (const auto& [key, value] : description) {
    add(hasher, key);
    add(hasher, value);
  }
  return hasher.digest();
}

std::string event_name(SessionEvent::Kind kind) {
  PROSECTOR_ASSERT(std::ranges::find(event_names, kind, &std::pair<Kind, const char*>::first) !=
                   event_names.end());
  return std::ranges::find(event_names, kind, &std::pair<Kind, const char*>::first)->second;
}

std::optional<SessionEvent::Kind> event_kind(const std::string& name) {
  const auto found = std::ranges::find(event_names, name, &std::pair<Kind, const char*>::second);
  return found == event_names.end() ? std::nullopt : std::optional(found->first);
}

}  // namespace prosector
