#include "server/physics/checkpoint.h"

#include <algorithm>

#include "common/hand.h"
#include "server/physics/contact/area_contacts.h"
#include "server/physics/contact/fit_tissue.h"
#include "server/physics/hands/hands.h"
#include "server/physics/organs/dissection_io.h"
#include "server/physics/organs/refined_io.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x31746e696f704350;              // "PCpoint1"
constexpr std::uint64_t magic_cut = 0x32746e696f704350;          // "PCpoint2": with what was cut
constexpr std::uint64_t magic_refined = 0x33746e696f704350;      // "PCpoint3": with what is refined
constexpr std::uint64_t magic_cut_refined = 0x34746e696f704350;  // "PCpoint4": with both
constexpr std::size_t most_hands = 1024;
constexpr std::size_t most_corners = 1 << 20;  // of a collider
constexpr std::size_t most_memories = 1 << 24;
constexpr std::size_t most_layer_sides = 1'000'000;

void add(ByteWriter& out, const RigidMotion& motion) {
  out.add(motion.pose);
  out.add(motion.linear_velocity);
  out.add(motion.angular_velocity);
  out.add(static_cast<std::uint8_t>(motion.asleep));
  out.add(motion.quiet_seconds);
}

RigidMotion read_motion(ByteReader& in) {
  RigidMotion motion;
  motion.pose = in.pose();
  motion.linear_velocity = in.vector();
  motion.angular_velocity = in.vector();
  motion.asleep = in.flag();
  motion.quiet_seconds = in.number<double>();
  return motion;
}

void add(ByteWriter& out, const SoftBodyState& state) {
  for (const VecX* v :
       {&state.motion.x, &state.motion.v, &state.motion.x_prev, &state.motion.v_prev, &state.warm_start})
    out.add(*v);
  out.add(static_cast<std::uint8_t>(state.motion.has_history));
  // One byte: whether it sleeps, and above that bit how far it is stepped down.
  out.add(static_cast<std::uint8_t>((state.asleep ? 1 : 0) | state.steps_down << 1));
  out.add(state.quiet_ticks);
  out.add(state.tangled_ticks);
  if (state.history.size() > 0) out.add(state.history);  // elastic bodies' hashes are those from before it
  out.add(static_cast<std::uint8_t>(state.recovering));
  out.add(state.law_seconds);
  out.add(state.energy_slack);
  out.add(state.mode);
  out.add(state.omega);
}

SoftBodyState read_soft(ByteReader& in, const SoftBodyState& like) {
  SoftBodyState state;
  state.motion.x = in.vector(like.motion.x.size());
  state.motion.v = in.vector(like.motion.v.size());
  state.motion.x_prev = in.vector(like.motion.x_prev.size());
  state.motion.v_prev = in.vector(like.motion.v_prev.size());
  state.warm_start = in.vector(like.warm_start.size());
  state.motion.has_history = in.flag();
  const auto sleep_and_steps = in.number<std::uint8_t>();
  state.asleep = (sleep_and_steps & 1) != 0;
  state.steps_down = sleep_and_steps >> 1;
  in.require(state.steps_down <= static_cast<int>(max_steps_down), "stepped down too far");
  state.quiet_ticks = in.number<int>();
  state.tangled_ticks = in.number<int>();
  state.history.resize(like.history.size());
  if (like.history.size() > 0) state.history = in.vector(like.history.size());
  state.recovering = in.flag();
  state.law_seconds = in.number<double>();
  state.energy_slack = in.number<double>();
  state.mode = in.vector(like.mode.size());
  state.omega = in.number<double>();
  return state;
}

/// Adds memories. `layers`: whether some may be of layers; scenes without keep the hashes that they had.
void add(ByteWriter& out, const ContactMemories& memories, bool layers) {
  out.add(static_cast<std::uint64_t>(memories.size()));
  for (const ContactMemory& m : memories) {
    out.add(static_cast<std::uint8_t>(m.soft));
    out.add(static_cast<std::uint64_t>(m.body));
    out.add(m.feature);
    if (layers) out.add(m.met);
    out.add(m.grip);
    out.add(m.force);
    out.add(m.normal);
    out.add(m.stiffness);
    out.add(m.rest);
  }
}

ContactMemories read_memories(ByteReader& in, std::size_t features, bool layers) {
  ContactMemories memories;
  for (std::size_t left = in.count(most_memories); left > 0; --left) {
    ContactMemory& m = memories.emplace_back();
    m.soft = in.flag();
    m.body = in.number<std::uint64_t>();
    m.feature = in.number<std::uint32_t>();
    in.require(m.feature < features, "a contact of a surface that isn't there");
    if (layers) m.met = in.number<std::uint32_t>();
    m.grip = in.vector();
    m.force = in.number<double>();
    m.normal = in.vector();
    m.stiffness = in.number<double>();
    m.rest = in.number<double>();
    in.require(is_consistent(m), "a contact without force or stiffness, or with a rest gap above 0");
  }
  return memories;
}

void add(ByteWriter& out, const std::vector<PadMemory>& pads) {
  out.add(static_cast<std::uint64_t>(pads.size()));
  for (const PadMemory& pad : pads) {
    out.add(pad.part);
    out.add(static_cast<std::uint64_t>(pad.body));
    out.add(pad.place);
    out.add(pad.force);
    for (const Vec3& grip : pad.grip) out.add(grip);
  }
}

std::vector<PadMemory> read_pads(ByteReader& in, std::size_t rigid_bodies) {
  std::vector<PadMemory> pads;
  for (std::size_t left = in.count(most_memories); left > 0; --left) {
    PadMemory& pad = pads.emplace_back();
    pad.part = in.number<std::uint32_t>();
    pad.body = in.count(rigid_bodies - 1);
    pad.place = in.vector();
    pad.force = in.number<double>();
    for (Vec3& grip : pad.grip) grip = in.vector();
    in.require(pad.part >= 1 && pad.part <= hand_joints && pad.force > 0, "a pad that is none, or pulls");
  }
  return pads;
}

void add(ByteWriter& out, const Hand& hand) {
  out.add(hand.participant);
  out.add(static_cast<std::uint64_t>(hand.side));
  out.add(hand.target);
  out.add(hand.previous_target);
  for (const double f : hand.target_flexion) out.add(f);
  for (const double f : hand.flexion) out.add(f);
  // One byte: whether it holds something, and the bits above that: whether pads press, whether it draws, and
  // whether an arm moves it.
  out.add(static_cast<std::uint8_t>((hand.hold ? 1 : 0) | (hand.pads.empty() ? 0 : 2) | (hand.draws ? 4 : 0) |
                                    (hand.reaction ? 8 : 0)));
  if (hand.reaction) out.add(*hand.reaction);
  if (!hand.pads.empty()) add(out, hand.pads);
  if (!hand.hold) return;
  out.add(hand.hold->body);
  out.add(static_cast<std::uint64_t>(hand.hold->points.size()));
  for (const Hold::Point& p : hand.hold->points) {
    out.add(p.in_hand);
    out.add(p.in_body);
    out.add(p.vertex);
    out.add(p.stiffness);
    out.add(p.max_force);
  }
  out.add(static_cast<std::uint8_t>(hand.hold->lifted));
  out.add(hand.hold->resting_ticks);
}

void add(ByteWriter& out, const LayerSides& sides) {
  out.add(static_cast<std::uint64_t>(sides.size()));
  for (const auto& [bodies, list] : sides) {
    out.add(static_cast<std::uint64_t>(bodies.first));
    out.add(static_cast<std::uint64_t>(bodies.second));
    out.add(static_cast<std::uint64_t>(list.size()));
    for (const LayerSide& side : list) {
      out.add(side.a);
      out.add(side.b);
      out.add(side.normal);
    }
  }
}

LayerSides read_sides(ByteReader& in, std::size_t bodies) {
  LayerSides out;
  const std::size_t pairs = in.count(bodies * bodies);
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto a = in.number<std::uint64_t>(), b = in.number<std::uint64_t>();
    in.require(a <= b && b < bodies, "layers of bodies that aren't there");
    std::vector<LayerSide>& list = out[{a, b}];
    list.resize(in.count(most_layer_sides));
    for (LayerSide& side : list) {
      side.a = in.number<std::uint32_t>();
      side.b = in.number<std::uint32_t>();
      side.normal = in.vector();
    }
  }
  return out;
}

void add(ByteWriter& out, const Entanglements& entangled) {
  out.add(static_cast<std::uint64_t>(entangled.size()));
  for (const auto& [bodies, how] : entangled) {
    out.add(static_cast<std::uint64_t>(bodies.first));
    out.add(static_cast<std::uint64_t>(bodies.second));
    out.add(how.way);
    out.add(static_cast<std::uint8_t>(how.whole));
    out.add(how.seconds);
  }
}

Entanglements read_entangled(ByteReader& in, std::size_t bodies) {
  Entanglements out;
  if (in.done()) return out;
  for (std::size_t left = in.count(bodies * bodies); left > 0; --left) {
    const auto a = in.number<std::uint64_t>(), b = in.number<std::uint64_t>();
    in.require(a < b && b < bodies, "entangled bodies that aren't there");
    Entanglement& how = out[{a, b}];
    how.way = in.vector();
    how.whole = in.flag();
    how.seconds = in.number<double>();
    in.require(how.seconds >= 0, "bodies entangled for less than no time");
  }
  return out;
}

void add(ByteWriter& out, const Lingerers::Map& watched) {
  out.add(static_cast<std::uint64_t>(watched.size()));
  for (const auto& [body, how] : watched) {
    out.add(body);
    out.add(how.place);
    out.add(how.ticks);
  }
}

Lingerers::Map read_lingerers(ByteReader& in, std::size_t rigid, std::span<const SoftBody* const> tissues) {
  Lingerers::Map out;
  if (in.done()) return out;
  for (std::size_t left = in.count(rigid + tissues.size()); left > 0; --left) {
    const auto body = in.number<BodyId>();
    in.require(body < rigid + tissues.size(), "a body that lingers and isn't there");
    Lingering& how = out[body];
    how.place = in.vector(body < rigid ? pose_numbers : 3 * tissues[body - rigid]->nodes());
    how.ticks = in.number<int>();
    in.require(how.ticks >= 0, "a body that lingers for less than no time");
  }
  return out;
}

void add(ByteWriter& out, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    for (const bool flag : {part.attached, part.hidden, part.lit, part.inspected})
      out.add(static_cast<std::uint8_t>(flag));
    out.add(part.opacity);
    out.add(part.stiffness);
    for (int column = 0; column < 3; ++column) out.add(Vec3(part.shape.A.col(column)));
    out.add(part.shape.p);
  }
}

std::vector<Part> read_parts(ByteReader& in, std::vector<Part> parts) {
  if (in.done()) return parts;
  for (Part& part : parts) {
    for (bool* flag : {&part.attached, &part.hidden, &part.lit, &part.inspected}) *flag = in.flag();
    part.opacity = in.number<double>();
    part.stiffness = in.number<double>();
    for (int column = 0; column < 3; ++column) part.shape.A.col(column) = in.vector();
    part.shape.p = in.vector();
    in.require(part.opacity >= 0 && part.opacity <= 1, "an opacity beyond 0 to 1");
    in.require(part.stiffness >= least_stiffness && part.stiffness <= most_stiffness,
               "a stiffness out of range");
  }
  return parts;
}

using LostBodies = std::map<BodyId, std::uint8_t>;

void add(ByteWriter& out, const LostBodies& lost) {
  out.add(static_cast<std::uint64_t>(lost.size()));
  for (const auto& [body, times] : lost) {
    out.add(body);
    out.add(times);
  }
}

LostBodies read_lost(ByteReader& in, std::size_t bodies) {
  LostBodies lost;
  if (in.done()) return lost;
  for (std::size_t left = in.count(bodies); left > 0; --left) {
    const auto body = in.number<BodyId>();
    in.require(body < bodies, "a lost body that isn't there");
    lost[body] = in.number<std::uint8_t>();
  }
  return lost;
}

Hand read_hand(ByteReader& in, const Model& model, std::span<const SoftBody* const> tissues) {
  Hand hand;
  hand.participant = in.number<ParticipantId>();
  hand.side = in.count(1);
  hand.target = in.pose();
  hand.previous_target = in.pose();
  for (double& f : hand.target_flexion) f = in.number<double>();
  for (double& f : hand.flexion) f = in.number<double>();
  const auto holds = in.number<std::uint8_t>();
  in.require(holds <= 15 && ((holds & 2) == 0 || !model.rigid.empty()),
             "a hand that neither holds nor doesn't");
  hand.draws = (holds & 4) != 0;
  if ((holds & 8) != 0) hand.reaction = in.number<double>();
  in.require(!hand.reaction || *hand.reaction >= 0, "an arm that pushes with no force");
  if ((holds & 2) != 0) hand.pads = read_pads(in, model.rigid.size());
  if ((holds & 1) == 0) return hand;
  Hold& hold = hand.hold.emplace();
  hold.body = in.number<BodyId>();
  in.require(hold.body < model.rigid.size() + tissues.size(), "a hold on a body that isn't there");
  const bool tissue = hold.body >= model.rigid.size();
  in.require(tissue || model.rigid[hold.body].setup.mass > 0, "a hold on a fixed body");
  hold.points.resize(in.count(max_hold_points));
  for (Hold::Point& p : hold.points) {
    p.in_hand = in.vector();
    p.in_body = in.vector();
    p.vertex = in.number<std::uint32_t>();
    in.require(
        !tissue || p.vertex < tissues[hold.body - model.rigid.size()]->anatomy().surface.positions.size(),
        "a hold on a vertex that isn't there");
    p.stiffness = in.number<double>();
    p.max_force = in.number<double>();
    in.require(p.stiffness > 0 && p.max_force > 0, "a hold without force");
  }
  hold.lifted = in.flag();
  hold.resting_ticks = in.number<int>();
  return hand;
}

/// Returns how many features contacts may be remembered at.
std::size_t most_features(const Anatomy& anatomy) {
  const TriangleMesh& surface = anatomy.surface;
  const std::size_t features = area_features(surface) + surface.triangles.size() + most_corners;
  // Nodes, at most three edges of each element, and the elements themselves.
  const std::size_t of_thin =
      anatomy.thickness > 0
          ? anatomy.tets.positions.size() + 4 * (surface.triangles.size() + anatomy.segments.size())
          : 0;
  return std::max(features, of_thin);
}

/// Reads hands, and puts them into the rigid world.
std::vector<Hand> read_hands(ByteReader& in, const Model& model, std::span<const SoftBody* const> tissues,
                             RigidWorld& world) {
  std::vector<Hand> hands(in.count(most_hands));
  for (Hand& hand : hands) {
    hand = read_hand(in, model, tissues);
    hand.slot = add_hand(model, world, hand, read_motion(in));
    if (hand.hold && hand.hold->body < model.rigid.size())
      world.set_collides(hand.slot, hand.hold->body, false);
  }
  for (std::size_t i = 1; i < hands.size(); ++i)
    in.require(std::pair(hands[i - 1].participant, hands[i - 1].side) <
                   std::pair(hands[i].participant, hands[i].side),
               "hands out of order");
  return hands;
}

/// Saves the state with those of the lingerers that are given.
void save(const State& state, const Lingerers::Map& watched, ByteWriter& out) {
  const Bodies& bodies = state.bodies;
  const Model& model = bodies.model;
  const bool cut = state.dissection.ever_cut(), refined = any_refined(state), thin = has_thin_shells(bodies);
  out.add(refined ? (cut ? magic_cut_refined : magic_refined) : (cut ? magic_cut : magic));
  out.raw(model.hash.data(), model.hash.size());
  out.add(state.time.epoch);
  out.add(state.time.tick);
  if (cut) save_cuts(state, out);
  if (refined) save_refined(state, out);
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot) add(out, bodies.rigid.motion(slot));
  for (const Tissue& tissue : bodies.soft) add(out, tissue.state);
  for (const Tissue& tissue : bodies.soft) add(out, tissue.memories, thin);
  out.add(static_cast<std::uint64_t>(state.hands.size()));
  for (const Hand& hand : state.hands) {
    add(out, hand);
    add(out, bodies.rigid.motion(hand.slot));
  }
  if (state.panels) {
    state.panels->save(out);
    out.add(state.room_lights);
  }
  if (thin) add(out, state.layer_sides);
  // Nothing while nobody made anything of any part, none was lost, none are in each other and none linger:
  // earlier sessions keep their hashes.
  const bool with_lingerers = !watched.empty(), with_entangled = with_lingerers || !state.entangled.empty(),
             with_lost = with_entangled || !bodies.lost.empty();
  if (with_lost || bodies.parts != initial_parts(model, bodies.soft.size())) add(out, bodies.parts);
  if (with_lost) add(out, bodies.lost);
  if (with_entangled) add(out, state.entangled);
  if (with_lingerers) add(out, watched);
}

struct CheckpointKind {
  bool cut = false, refined = false;
};
CheckpointKind read_kind(ByteReader& in) {
  const auto kind = in.number<std::uint64_t>();
  const CheckpointKind out = {kind == magic_cut || kind == magic_cut_refined,
                              kind == magic_refined || kind == magic_cut_refined};
  in.require(out.cut || out.refined || kind == magic, "not a checkpoint of this version");
  return out;
}

}  // namespace

void save(const State& state, ByteWriter& out) {
  save(state, state.lingerers.watched(), out);
}

RestoredState::RestoredState(State& state, std::span<const std::uint8_t> bytes)
    : state_(state),
      cuts_(state),
      refinements_(state),
      rigid_(state.bodies.model.scene.gravity, room_sides(state.bodies.model.scene.room)) {
  ByteReader in(bytes, "checkpoint");
  read(in);
  in.require(in.done(), "more than a checkpoint holds");
}

void RestoredState::read(ByteReader& in) {
  const Bodies& bodies = state_.bodies;
  const Model& model = bodies.model;
  const bool thin = has_thin_shells(bodies);
  const auto [cut, refined] = read_kind(in);
  for (const std::uint8_t b : model.hash)
    in.require(in.number<std::uint8_t>() == b, "made from another scene");
  time_.epoch = in.number<std::uint32_t>();
  time_.tick = in.number<std::uint64_t>();
  if (cut) cuts_.read(in);
  if (refined) refinements_.read(in, cuts_);
  std::vector<const SoftBody*> tissues = cuts_.bodies();
  refinements_.replace(tissues);
  for (const RigidModel& r : model.rigid) rigid_.add(r.setup, read_motion(in));
  for (const SoftBody* body : tissues) soft_.push_back(read_soft(in, body->initial_state()));
  for (const SoftBody* body : tissues)
    memories_.push_back(read_memories(in, most_features(body->anatomy()), thin));
  hands_ = read_hands(in, model, tissues, rigid_);
  if (state_.panels) {
    panels_.emplace(model.h).load(in, model.rigid.size() + tissues.size());
    room_lights_ = in.number<double>();
    in.require(room_lights_ >= 0 && room_lights_ <= 1, "a brightness beyond 0 to 1");
  }
  if (thin) layer_sides_ = read_sides(in, tissues.size());
  parts_ = read_parts(in, initial_parts(model, tissues.size()));
  lost_ = read_lost(in, model.rigid.size() + tissues.size());
  entangled_ = read_entangled(in, tissues.size());
  lingerers_ = read_lingerers(in, model.rigid.size(), tissues);
}

void RestoredState::take_effect() {
  Bodies& bodies = state_.bodies;
  cuts_.take_effect();
  refinements_.take_effect();
  state_.time = time_;
  bodies.rigid = std::move(rigid_);
  for (std::size_t i = 0; i < bodies.soft.size(); ++i) {
    bodies.soft[i].state = std::move(soft_[i]);
    bodies.soft[i].memories = std::move(memories_[i]);
  }
  state_.hands = std::move(hands_);
  bodies.parts = std::move(parts_);
  bodies.lost = std::move(lost_);
  state_.entangled = std::move(entangled_);
  state_.lingerers.set(std::move(lingerers_));
  state_.layer_sides = std::move(layer_sides_);
  state_.panels = std::move(panels_);
  state_.room_lights = room_lights_;
  for (BodyId body = 0; body < bodies.parts.size(); ++body) bodies.take_effect(bodies.rigid, body);
  for (Tissue& tissue : bodies.soft) tissue.place_surface();
}

void load(State& state, std::span<const std::uint8_t> bytes) {
  RestoredState(state, bytes).take_effect();
}

std::uint64_t hash_of(const State& state) {
  StateHasher hasher;
  ByteWriter bytes;
  save(state, state.lingerers.calmed_next(), bytes);  // others don't change the next tick
  hasher.add(std::as_bytes(std::span(bytes.bytes())));
  state.bodies.rigid.hash(hasher);
  return hasher.digest();
}

}  // namespace prosector
