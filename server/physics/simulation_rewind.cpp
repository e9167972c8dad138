// Last phase: going back to an earlier state. The logs of cuts go on, so revisions and ids never repeat; the
// hands that are there stay where they are, holding nothing.

#include <algorithm>

#include "common/error.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

/// What clients have of a soft body, to tell whether it becomes another.
struct Shown {
  std::uint64_t content_hash = 0;
  Numbering numbering;
  bool operator==(const Shown& other) const {
    return content_hash == other.content_hash && numbering.nodes == other.numbering.nodes &&
           numbering.vertices == other.numbering.vertices && numbering.triangles == other.numbering.triangles;
  }
};

}  // namespace

/// Empty when done, else why not; then nothing changed but caches, which are made anew.
std::string Simulation::Impl::rewind(const CutEvent& event) {
  if (!event.state) return "that state was not kept";
  ByteWriter now;
  save(now);
  try {
    go_back(event);
    return {};
  } catch (const InputError& error) {
    load(now.bytes());
    return error.what();
  }
}

/// Throws InputError for a state that isn't of this run.
void Simulation::Impl::go_back(const CutEvent& event) {
  const SimTime left = time;
  const std::uint64_t strokes_left = strokes;
  const std::size_t count = soft.size();
  std::vector<Shown> shown;
  std::vector<int> steps_down;
  for (std::size_t i = 0; i < count; ++i) {
    shown.push_back({model.soft[i]->content_hash(), numberings[i]});
    steps_down.push_back(soft[i].steps_down);
  }
  const std::vector<std::uint32_t> revisions_left = revisions;
  const std::vector<Hand> present = hands;
  std::vector<RigidMotion> motions;
  for (const Hand& hand : present) motions.push_back(world.motion(hand.slot));
  std::map<std::size_t, Organ> cut = organs;

  load(*event.state);
  islands.clear();  // of the state that was
  if (soft.size() > count) throw InputError("cutting: a state to go back to has bodies that never were");
  for (const auto& [first, then] : organs)
    if (!cut.contains(first)) throw InputError("cutting: a state to go back to has another past");
  for (auto& [first, organ] : cut) {
    const auto then = organs.find(first);
    organ.rewind(then != organs.end()
                     ? then->second
                     : Organ(first, organ.whole(), model.soft[first]->desc().density, organ.held()),
                 event.participant);
  }
  organs = std::move(cut);
  blades.clear();
  strokes = strokes_left;
  time = {left.epoch + 1, left.tick};
  report.time = time;

  // Pieces that came since are bodies still, of nothing.
  for (std::size_t body = soft.size(); body < count; ++body) {
    const auto owner = std::find_if(organs.begin(), organs.end(), [&](const auto& entry) {
      const auto& pieces = entry.second.pieces();
      return std::any_of(pieces.begin(), pieces.end(), [&](const OrganPiece& p) { return p.body == body; });
    });
    Numbering numbering;
    std::unique_ptr<SoftBody> solver = make_piece(owner->second, body, numbering);
    SurfaceDetector surface = detector(*solver);
    place_piece(body, owner->first, std::move(solver), std::move(numbering), std::move(surface));
    parts[soft_id(body)].hidden = true;
    take_effect(world, soft_id(body));
    place_surface(body);
  }
  for (std::size_t i = 0; i < count; ++i) {
    soft[i].steps_down = steps_down[i];  // the server is as busy as it was
    std::erase_if(memories[i], [&](const ContactMemory& m) {
      return !m.soft && m.body >= model.rigid.size() && !is_room(m.body);
    });
    revisions[i] = revisions_left[i];
    const std::uint64_t content_hash = model.soft[i]->content_hash();
    if (shown[i] == Shown{content_hash, numberings[i]}) continue;
    TopologyChange& change = report.topology.emplace_back();
    change.body = soft_id(i);
    change.revision = ++revisions[i];
    change.content_hash = content_hash;
    change.cause = TopologyCause::rewind;
    change.author = event.participant;
  }
  bring_back_hands(present, motions);
}

/// In place of those that were there then.
void Simulation::Impl::bring_back_hands(std::span<const Hand> present, std::span<const RigidMotion> motions) {
  for (; !hands.empty(); hands.pop_back()) world.remove(hands.back().slot);
  for (std::size_t i = 0; i < present.size(); ++i) {
    Hand& hand = hands.emplace_back(present[i]);
    if (hand.hold)
      report.let_go.push_back({hand.participant, hand.side, hand.hold->body, "everything was rewound"});
    hand.hold.reset();
    hand.slot = add_hand(world, hand, motions[i]);
  }
  describe_hands();
}

std::size_t Simulation::Impl::add_hand(RigidWorld& rigid_world, const Hand& hand,
                                       const RigidMotion& motion) const {
  const HandModel& shape = model.hands[hand.side];
  const std::size_t slot = rigid_world.add(shape.setup, motion);
  const auto poses = hand_part_poses(hand.side, hand.flexion, shape.center);
  for (std::size_t part = 0; part < poses.size(); ++part) rigid_world.set_part_pose(slot, part, poses[part]);
  return slot;
}

}  // namespace prosector
