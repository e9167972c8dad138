#pragma once
// Topology changes of soft bodies, as reported to the session. Each change is an immutable revision. Nodes,
// vertices and triangles have permanent numbers, so a change can be sent as a difference.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/hash.h"
#include "common/ids.h"
#include "common/surface_change.h"

namespace prosector {

/// Permanent number of each node, vertex and triangle of a soft body's anatomy, by its current index;
/// ascending. Numbers are never reused. Empty lists mean that the body was never cut and each number equals
/// the index.
struct Numbering {
  std::vector<std::uint32_t> nodes, vertices, triangles;
};

/// A change of a body's topology, reported by the step after which the simulation has the new topology. A
/// piece that came free is a new body; its first change has revision 0. A body of which nothing is left has
/// no triangles.
struct TopologyChange {
  BodyId body = 0;
  std::uint32_t revision = 0;
  std::uint64_t content_hash = 0;  // connectivity, rest shape, masses
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;        // 0: nobody
  std::optional<BodyId> piece_of;  // of a new piece: the body that it was cut off
};

/// A participant's request that concerns earlier cuts: undo or rewind. It is recorded in the journal with the
/// tick that consumes it.
struct CutEvent {
  enum class Kind : std::uint8_t {
    undo,    // the participant's last cut that was not undone yet
    rewind,  // everything as it was when `body` got `revision`; starts an epoch, in which ticks go on
             // counting
  } kind = Kind::undo;
  ParticipantId participant = 0;
  BodyId body = 0;             // of rewind
  std::uint32_t revision = 0;  // of rewind
  /// Saved state to which `rewind` returns: the result of Simulation::save() at that time, in this run or in
  /// the run that it continues. Null if it is no longer stored.
  std::shared_ptr<const std::vector<std::uint8_t>> state{};
};
inline constexpr CutEvent::Kind last_cut_event = CutEvent::Kind::rewind;

}  // namespace prosector
