#pragma once
// The log of an organ: every cut, undo and rewind, in order. It only grows; undone changes stay in it.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/ids.h"
#include "common/refusal.h"
#include "common/surface_change.h"
#include "server/physics/base/topology.h"
#include "server/physics/mechanics/cutting/topology_op.h"

namespace prosector {

/// An entry of the log.
struct OrganChange {
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;
  /// Cuts of one stroke are undone together. Of an undo: the undone stroke. Of a rewind: the length of the
  /// log to which it went back.
  std::uint64_t stroke = 0;
  std::vector<TopologyOp> ops;  // of a cut
  // Tetrahedra that later cuts must not touch if this cut is to be undone; ascending.
  std::vector<TetId> touched;
  bool taken_back = false;  // by a later undo or rewind
};

using OrganLog = std::vector<OrganChange>;

/// Returns the cuts of the author's last stroke in force, newest first.
std::vector<OrganChange*> stroke_of(OrganLog& log, ParticipantId author);
/// Returns the number of the author's last stroke in force; none: there is none.
std::optional<std::uint64_t> last_stroke(const OrganLog& log, ParticipantId author);
/// Returns the reason why the stroke's cuts can't be undone, if a later cut depends on them.
Refusal why_not_undone(const OrganLog& log, std::span<OrganChange* const> stroke);
/// Returns whether no cut is in force.
bool is_uncut(const OrganLog& log);
/// Returns whether the log begins with the entries of `start`.
bool begins_with(const OrganLog& log, const OrganLog& start);

}  // namespace prosector
