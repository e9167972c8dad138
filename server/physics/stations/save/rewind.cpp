#include "server/physics/stations/save/rewind.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/error.h"
#include "server/physics/stations/dissecting/piece_builder.h"
#include "server/physics/stations/dissecting/refining.h"
#include "server/physics/stations/hands/hands.h"
#include "server/physics/stations/save/checkpoint.h"

namespace prosector {
namespace {

/// Client-side state of a soft body before a rewind, to detect whether the rewind changes it.
struct Shown {
  std::uint64_t content_hash = 0;
  Numbering numbering;
  std::uint32_t revision = 0;
  int steps_down = 0;
  bool equals_topology(std::uint64_t hash, const Numbering& other) const {
    return content_hash == hash && numbering.nodes == other.nodes && numbering.vertices == other.vertices &&
           numbering.triangles == other.triangles;
  }
};

/// Keeps pieces that came since as bodies, of nothing.
void keep_later_pieces(State& state, std::size_t count) {
  Bodies& bodies = state.bodies;
  for (std::size_t body = bodies.soft.size(); body < count; ++body) {
    const auto owner =
        std::find_if(state.dissection.organs.begin(), state.dissection.organs.end(), [&](const auto& entry) {
          const auto& pieces = entry.second.pieces();
          return std::any_of(pieces.begin(), pieces.end(),
                             [&](const organs::OrganPiece& p) { return p.body == body; });
        });
    Numbering numbering;
    std::unique_ptr<soft::SoftBody> solver = make_piece(bodies, owner->second, body, numbering);
    contact::TissueSurface surface(solver->anatomy());
    place_piece(state, body, owner->first, std::move(solver), std::move(numbering), std::move(surface));
    bodies.parts[bodies.soft_id(body)].hidden = true;
    bodies.take_effect(bodies.rigid, bodies.soft_id(body));
    bodies.soft[body].place_surface();
  }
}

/// Reports the bodies that clients have to reload. `was`: previous client-side state, by soft body.
void report_changes(State& state, std::span<const Shown> was, ParticipantId author, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (std::size_t i = 0; i < was.size(); ++i) {
    Tissue& tissue = bodies.soft[i];
    tissue.state.steps_down = was[i].steps_down;  // the server is as busy as it was
    std::erase_if(tissue.memories, [&](const contact::ContactMemory& m) {
      return !m.soft && m.body >= bodies.model.rigid.size() && !rigid::is_room(m.body);
    });
    tissue.revision = was[i].revision;
    const std::uint64_t content_hash = topology_hash(state, i);
    if (was[i].equals_topology(content_hash, tissue.numbering)) continue;
    TopologyChange& change = report.topology.emplace_back();
    change.body = bodies.soft_id(i);
    change.revision = ++tissue.revision;
    change.content_hash = content_hash;
    change.cause = TopologyCause::rewind;
    change.author = author;
  }
}

/// Puts the hands that are there now in place of those that were there then.
void restore_hands(State& state, std::span<const hands::Hand> present,
                   std::span<const rigid::RigidMotion> motions, StepReport& report) {
  for (; !state.hands.empty(); state.hands.pop_back()) state.bodies.rigid.remove(state.hands.back().slot);
  for (std::size_t i = 0; i < present.size(); ++i) {
    hands::Hand& hand = state.hands.emplace_back(present[i]);
    if (hand.hold)
      report.let_go.push_back({hand.participant, hand.side, hand.hold->body, "everything was rewound"});
    hand.hold.reset();
    hand.slot = add_hand(state.bodies.model, state.bodies.rigid, hand, motions[i]);
  }
}

/// Returns why this run can't rewind to the given state: it isn't one of the run's own past states.
Refusal refuse_foreign_state(const State& state, const RestoredState& past) {
  if (past.soft_bodies() > state.bodies.soft.size())
    return "cannot rewind: the saved state has pieces of cut bodies that never existed in this session";
  const std::map<std::size_t, organs::Organ>& cut = state.dissection.organs;
  for (const auto& [first, then] : past.cuts().organs())
    if (!cut.contains(first) || !cut.at(first).has_past(then))
      return "cannot rewind: the cuts in the saved state are not earlier cuts of this session";
  return {};
}

void go_back(State& state, RestoredState& past, const CutEvent& event, StepReport& report) {
  Bodies& bodies = state.bodies;
  const SimTime left = state.time;
  const std::uint64_t strokes_left = state.dissection.strokes;
  const std::size_t count = bodies.soft.size();
  std::vector<Shown> shown;
  for (const Tissue& tissue : bodies.soft)
    shown.push_back(
        {topology_hash(state, tissue.index), tissue.numbering, tissue.revision, tissue.state.steps_down});
  const std::vector<hands::Hand> present = state.hands;
  std::vector<rigid::RigidMotion> motions;
  for (const hands::Hand& hand : present) motions.push_back(bodies.rigid.motion(hand.slot));
  std::map<std::size_t, organs::Organ> cut = state.dissection.organs;

  past.take_effect();
  for (auto& [first, organ] : cut) {
    take_refinement_back(state, first);  // it goes on as one that was cut
    const auto then = state.dissection.organs.find(first);
    organ.rewind(then != state.dissection.organs.end()
                     ? then->second
                     : organs::Organ(first, organ.whole(), bodies.soft[first].solver->desc().material.density,
                                     organ.held()),
                 event.participant);
  }
  state.dissection.organs = std::move(cut);
  state.dissection.blades.clear();
  state.dissection.strokes = strokes_left;
  state.time = {left.epoch + 1, left.tick};
  report.time = state.time;
  keep_later_pieces(state, count);
  report_changes(state, shown, event.participant, report);
  restore_hands(state, present, motions, report);
}

/// Reads the state to go back to. Refused: its bytes are none of this scene.
Refusal read_past(State& state, const CutEvent& event, std::optional<RestoredState>& past) {
  try {
    past.emplace(state, *event.state);
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace

Refusal rewind(State& state, const CutEvent& event, StepReport& report) {
  if (!event.state) return "cannot rewind: the requested state is not stored";
  std::optional<RestoredState> past;
  if (Refusal why = read_past(state, event, past)) return why;
  if (Refusal why = refuse_foreign_state(state, *past)) return why;
  go_back(state, *past, event, report);
  return {};
}

}  // namespace prosector
