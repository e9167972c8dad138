#include "server/session/sending/snapshot.h"

#include "common/mesh.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

const SoftSnapshot* find(const Snapshot* previous, BodyId body) {
  if (previous != nullptr)
    for (const SoftSnapshot& s : previous->soft)
      if (s.body == body) return &s;
  return nullptr;
}

SoftSnapshot take_soft(const Simulation& simulation, BodyId body, const TopologyLog& topology,
                       const SoftSnapshot* before) {
  SoftSnapshot out;
  out.body = body;
  out.revision = topology.revision(body);
  out.stream = topology.stream(body);
  out.rehung = simulation.rehung(body);
  if (before != nullptr && before->rehung == out.rehung && before->stream == out.stream)
    out.sources = before->sources;
  else if (out.rehung > 0)
    out.sources =
        std::make_shared<SparseMap>(sources_of(*out.stream, simulation.soft(body).anatomy().embedding));
  out.asleep = simulation.asleep(body);
  const soft::Motion& motion = simulation.soft_state(body).motion;
  // A reset moves a body without waking it, so the positions of a sleeping body are compared, too.
  if (out.asleep && before != nullptr && before->asleep && before->revision == out.revision &&
      before->rehung == out.rehung && *before->x == motion.x) {
    out.x = before->x;
    out.v = before->v;
  } else {
    out.x = std::make_shared<VecX>(motion.x);
    out.v = std::make_shared<VecX>(motion.v);
  }
  return out;
}

std::vector<UserState> take_users(const Simulation& simulation, const Session& session) {
  std::vector<UserState> out;
  for (const auto& [id, member] : session.roster().members()) {
    const HandInput* input = session.newest_input(id);
    if (input == nullptr) continue;
    UserState user;
    user.participant = id;
    user.time = simulation.time();
    user.input_sequence = input->sequence;
    user.head_tracked = input->head_tracked;
    user.head = input->head;
    for (const HandState& state : simulation.hands()) {
      if (state.participant != id) continue;
      const HandPose& asked = input->hands[state.hand];
      user.hands[state.hand] = {true, state.pose, state.flexion, asked.gesture, asked.buttons};
    }
    out.push_back(user);
  }
  return out;
}

}  // namespace

std::shared_ptr<Snapshot> take_snapshot(const Simulation& simulation, const Session& session,
                                        const TopologyLog& topology, const Snapshot* previous) {
  auto out = std::make_shared<Snapshot>();
  out->time = simulation.time();
  for (BodyId b = 0; b < simulation.body_count(); ++b) {
    if (simulation.kind(b) == BodyKind::soft)
      out->soft.push_back(take_soft(simulation, b, topology, find(previous, b)));
    else if (!simulation.scene().rigid[b].fixed)
      out->rigid.push_back({b, simulation.rigid_state(b)});
  }
  out->panels = simulation.panels();
  out->lights = simulation.room_lights();
  out->pace = session.pacing().pace();
  out->users = take_users(simulation, session);
  for (const HandState& hand : simulation.hands()) {
    out->contacts.push_back(hand.contact);
    ContactSample& contact = out->contacts.back();
    contact.participant = hand.participant;
    contact.hand = static_cast<std::uint8_t>(hand.hand);
    contact.time = out->time;
  }
  return out;
}

}  // namespace prosector
