#include "server/physics/stations/save/checkpoint.h"

#include <algorithm>

#include "server/physics/stations/hands/hands.h"
#include "server/physics/stations/save/records.h"
#include "server/physics/stations/save/saved_cuts.h"
#include "server/physics/stations/save/saved_refinements.h"
#include "server/physics/stations/touching/fit_tissue.h"

namespace prosector {
namespace {

constexpr std::uint64_t magic = 0x35746e696f704350;  // "PCpoint5"
constexpr std::size_t most_hands = 1024;

std::vector<const soft::SoftBody*> solvers_of(const Bodies& bodies) {
  std::vector<const soft::SoftBody*> out;
  for (const Tissue& tissue : bodies.soft) out.push_back(tissue.solver.get());
  return out;
}

/// Saves the state with those of the lingerers that are given.
void save(const State& state, const coupled::Lingerers::Map& watched, RecordWriter& io) {
  const Bodies& bodies = state.bodies;
  const Model& model = bodies.model;
  const std::vector<const soft::SoftBody*> tissues = solvers_of(bodies);
  const GraspableBodies graspable{model, tissues};
  io.number(magic, "format");
  for (const std::uint8_t byte : model.hash) io.number(byte, "scene");
  io.number(state.time.epoch, "epoch");
  io.number(state.time.tick, "tick");
  save_cuts(state, io);
  save_refined(state, io);
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot) {
    const auto in = io.scope(model.rigid[slot].name);
    const rigid::RigidMotion motion = bodies.rigid.motion(slot, rigid::RigidWorld::Rounding::none);
    entry(io, motion);
  }
  for (const Tissue& tissue : bodies.soft) {
    const auto in = io.scope(bodies.name_of(bodies.soft_id(tissue.index)));
    entry(io, tissue.state, tissue.state);
    entry(io, tissue.memories, most_features(tissue.anatomy()));
  }
  io.list(state.hands, most_hands, "hand", [&](const hands::Hand& hand) {
    entry(io, hand, graspable);
    const rigid::RigidMotion motion = bodies.rigid.motion(hand.slot, rigid::RigidWorld::Rounding::none);
    entry(io, motion);
  });
  if (state.panels) state.panels->save(io);
  io.number(state.room_lights, "room's lights");
  entry(io, state.layer_sides, tissues.size());
  for (BodyId body = 0; body < bodies.count(); ++body) {
    const auto in = io.scope(bodies.name_of(body));
    entry(io, bodies.parts[body]);
  }
  entry(io, bodies.lost, bodies.count());
  entry(io, state.entangled, tissues.size());
  entry(io, watched, graspable);
}

}  // namespace

void save(const State& state, ByteWriter& out, RecordLabels* labels) {
  RecordWriter io(out, labels);
  save(state, state.lingerers.watched(), io);
}

RestoredState::RestoredState(State& state, std::span<const std::uint8_t> bytes)
    : state_(state),
      cuts_(state),
      refinements_(state),
      rigid_(state.bodies.model.scene.gravity, rigid::room_sides(state.bodies.model.scene.room)) {
  ByteReader in(bytes, "checkpoint");
  RecordReader io(in);
  read(io);
  in.require(in.done(), "the checkpoint is damaged: there is data after its end");
}

void RestoredState::read(RecordReader& io) {
  const Bodies& bodies = state_.bodies;
  const Model& model = bodies.model;
  std::uint64_t format = 0;
  io.number(format, "format");
  io.require(format == magic, "the data is not a checkpoint, or one of another version of the server");
  for (const std::uint8_t byte : model.hash) {
    std::uint8_t saved = 0;
    io.number(saved, "scene");
    io.require(saved == byte, "from another scene");
  }
  io.number(time_.epoch, "epoch");
  io.number(time_.tick, "tick");
  cuts_.read(io);
  refinements_.read(io, cuts_);
  std::vector<const soft::SoftBody*> tissues = cuts_.bodies();
  refinements_.replace(tissues);
  const GraspableBodies graspable{model, tissues};
  for (const RigidModel& r : model.rigid) {
    rigid::RigidMotion motion;
    entry(io, motion);
    rigid_.add(r.setup, motion);
  }
  for (const soft::SoftBody* body : tissues) {
    entry(io, soft_.emplace_back(), body->initial_state());
    entry(io, memories_.emplace_back(), most_features(body->anatomy()));
  }
  io.list(hands_, most_hands, "hand", [&](hands::Hand& hand) { read_hand(io, hand, graspable); });
  if (state_.panels) panels_.emplace(model.h).load(io, model.rigid.size() + tissues.size());
  io.number(room_lights_, "room's lights");
  io.require(room_lights_ >= 0 && room_lights_ <= 1, "a brightness beyond 0 to 1");
  entry(io, layer_sides_, tissues.size());
  parts_.resize(model.rigid.size() + tissues.size());
  for (Part& part : parts_) entry(io, part);
  entry(io, lost_, parts_.size());
  entry(io, entangled_, tissues.size());
  entry(io, lingerers_, graspable);
}

/// Reads a hand, and puts it into the rigid world.
void RestoredState::read_hand(RecordReader& io, hands::Hand& hand, const GraspableBodies& graspable) {
  entry(io, hand, graspable);
  const bool first = &hand == hands_.data();
  io.require(
      first || std::pair((&hand)[-1].participant, (&hand)[-1].side) < std::pair(hand.participant, hand.side),
      "hands out of order");
  rigid::RigidMotion motion;
  entry(io, motion);
  hand.slot = add_hand(graspable.model, rigid_, hand, motion);
  if (hand.hold && hand.hold->body < graspable.model.rigid.size())
    rigid_.set_collides(hand.slot, hand.hold->body, false);
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
  RecordWriter io(bytes);
  save(state, state.lingerers.calmed_next(), io);  // others don't change the next tick
  hasher.add(std::as_bytes(std::span(bytes.bytes())));
  state.bodies.rigid.hash(hasher);
  return hasher.digest();
}

}  // namespace prosector
