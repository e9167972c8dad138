#pragma once
// What cutting makes of soft bodies, as the session hears of it. A change is an immutable revision; what it
// is made of keeps its number for ever, so a change can be told as a difference.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "common/messages.h"

namespace prosector {

/// The number that each node, vertex and triangle of a soft body's anatomy keeps for ever, by index.
/// Ascending. Empty lists: it was never cut, and each is its own index.
struct Numbering {
  std::vector<std::uint32_t> nodes, vertices, triangles;
};

/// A body's new topology: the simulation has it when the step ends. A piece that came free is a body that did
/// not exist before; its first change has revision 0. A body that became nothing has no triangles.
struct TopologyChange {
  BodyId body = 0;
  std::uint32_t revision = 0;
  std::uint64_t content_hash = 0;  // connectivity, rest shape, masses
  TopologyCause cause = TopologyCause::cut;
  ParticipantId author = 0;        // 0: nobody
  std::optional<BodyId> piece_of;  // of a new piece: the body that it was cut off
};

/// What somebody asks of cuts that were made; journalled with the tick that consumes it.
struct CutEvent {
  enum class Kind : std::uint8_t {
    undo,    // the participant's last cut that was not undone yet
    rewind,  // everything as it was when `body` got `revision`; starts an epoch, in which ticks go on
             // counting
  } kind = Kind::undo;
  ParticipantId participant = 0;
  BodyId body = 0;             // of rewind
  std::uint32_t revision = 0;  // of rewind
  /// What Simulation::save() gave then, in this run or the one that it goes on from; of rewind.
  std::shared_ptr<const std::vector<std::uint8_t>> state{};
};
inline constexpr CutEvent::Kind last_cut_event = CutEvent::Kind::rewind;

}  // namespace prosector
