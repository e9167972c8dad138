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

namespace prosector::organs {

/// Entry of an organ's log of changes: a cut, an undo or a rewind, with its author, the number of its stroke,
/// and the topology operations of a cut.
struct OrganChange {
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;
  /// For a cut, the number of the blade stroke to which it belongs; cuts of one stroke are undone together.
  /// For an undo, the undone stroke. For a rewind, the length of the log to which it went back.
  std::uint64_t stroke = 0;
  std::vector<cutting::TopologyOp> ops;  // of a cut
  // Tetrahedra that later cuts must not touch if this cut is to be undone; ascending.
  std::vector<cutting::TetId> touched;
  bool taken_back = false;  // by a later undo or rewind
};

using OrganLog = std::vector<OrganChange>;

/// Returns the log's entries for the cuts of the author's last stroke in force, newest first. Cuts that were
/// undone or rewound are not in force. Empty if the author has no cut in force.
std::vector<OrganChange*> stroke_of(OrganLog& log, ParticipantId author);
/// Returns the number of the author's last stroke that has cuts in force, neither undone nor rewound; none if
/// there is no such stroke.
std::optional<std::uint64_t> last_stroke(const OrganLog& log, ParticipantId author);
/// Returns the reason why the cuts of `stroke` can't be undone, namely that a later cut in force touched the
/// same tetrahedra. Empty if they can be undone.
Refusal why_not_undone(const OrganLog& log, std::span<OrganChange* const> stroke);
/// Returns whether no cut in an organ's log is in force: there was none, or all were undone or rewound.
bool is_uncut(const OrganLog& log);
/// Returns whether the first entries of `log` equal all entries of `start`, compared by cause, author, stroke
/// and topology operations.
bool begins_with(const OrganLog& log, const OrganLog& start);

}  // namespace prosector::organs
