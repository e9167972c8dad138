#pragma once
// The log of an organ: every cut, undo and rewind, in order. It only grows; what is undone stays in it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/byte_stream.h"
#include "common/messages.h"
#include "common/refusal.h"
#include "server/physics/cutting/topology_op.h"
#include "server/physics/topology.h"

namespace prosector {

struct OrganChange {
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;
  /// Cuts of one stroke are undone together. An undo names the stroke undone; a rewind, how many entries of
  /// the log it went back to.
  std::uint64_t stroke = 0;
  std::vector<TopologyOp> ops;  // of a cut
  std::vector<TetId> touched;   // of a cut: what later cuts must leave alone for it to be undone; ascending
  bool taken_back = false;      // by a later undo or rewind
};

using OrganLog = std::vector<OrganChange>;

/// Returns the cuts of the author's last stroke in force, newest first.
std::vector<OrganChange*> stroke_of(OrganLog& log, ParticipantId author);
/// Returns the number of that stroke; none: there is none.
std::optional<std::uint64_t> last_stroke(const OrganLog& log, ParticipantId author);
/// Returns why the stroke's cuts can't be undone, where a later cut depends on them.
Refusal why_not_undone(const OrganLog& log, std::span<OrganChange* const> stroke);
/// Returns whether no cut is in force.
bool is_uncut(const OrganLog& log);
/// Returns whether the log begins with the entries of `start`.
bool begins_with(const OrganLog& log, const OrganLog& start);

void save(ByteWriter& out, std::span<const OrganChange> changes);
/// Reads one entry, without what follows from it: touched, taken_back. Throws InputError for what doesn't
/// fit.
OrganChange read_change(ByteReader& in);

inline constexpr std::size_t most_changes = 10'000'000;  // that a saved log may have

}  // namespace prosector
