#pragma once
// The records of a checkpoint that are neither of cuts nor of panels (base/record.h). Functions that check
// indices take what they refer to.

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "common/commands.h"
#include "common/hand.h"
#include "server/physics/base/record.h"
#include "server/physics/mechanics/soft/base/effort.h"
#include "server/physics/stations/touching/area_contacts.h"
#include "server/physics/world/state.h"

namespace prosector {

inline constexpr std::size_t most_memories = 1 << 24;
inline constexpr std::size_t most_layer_sides = 1'000'000;
inline constexpr std::size_t most_corners = 1 << 20;  // of a collider

template <class Io>
void entry(Io& io, typename Io::template Entry<rigid::RigidMotion>& motion) {
  auto& [pose, linear_velocity, angular_velocity, asleep, quiet_seconds] = motion;
  io.pose(pose, "pose");
  io.vector(linear_velocity, "linear velocity");
  io.vector(angular_velocity, "angular velocity");
  io.flag(asleep, "asleep");
  io.number(quiet_seconds, "quiet seconds");
}

/// Writes or reads (as `io` does) a soft body's state in a checkpoint. `like` is the state of this body at
/// the start of the scene; its vectors have the same lengths.
template <class Io>
void entry(Io& io, typename Io::template Entry<soft::SoftBodyState>& state, const soft::SoftBodyState& like) {
  auto& [motion, warm_start, history, asleep, quiet_ticks, tangled_ticks, steps_down, recovering, law_seconds,
         energy_slack, mode, omega] = state;
  auto& [x, v, x_prev, v_prev, has_history] = motion;
  io.vector(x, like.motion.x.size(), "positions");
  io.vector(v, like.motion.v.size(), "velocities");
  io.vector(x_prev, like.motion.x_prev.size(), "previous positions");
  io.vector(v_prev, like.motion.v_prev.size(), "previous velocities");
  io.vector(warm_start, like.warm_start.size(), "warm start");
  io.flag(has_history, "has history");
  io.flag(asleep, "asleep");
  io.number(steps_down, "steps down");
  io.require(steps_down >= 0 && steps_down <= static_cast<int>(max_steps_down),
             "effort reduction out of range");
  io.number(quiet_ticks, "quiet ticks");
  io.number(tangled_ticks, "tangled ticks");
  io.vector(history, like.history.size(), "viscoelastic history");
  io.flag(recovering, "recovering");
  io.number(law_seconds, "seconds under another law");
  io.number(energy_slack, "energy slack");
  io.vector(mode, like.mode.size(), "fastest mode");
  io.number(omega, "fastest angular frequency");
}

/// Returns an upper bound of the feature indices (vertices, face points, edges and elements) of a body's
/// surface that a stored contact may refer to.
inline std::size_t most_features(const Anatomy& anatomy) {
  const TriangleMesh& surface = anatomy.surface;
  const std::size_t features = area_features(surface) + surface.triangles.size() + most_corners;
  // Nodes, at most three edges of each element, and the elements themselves.
  const std::size_t of_thin =
      anatomy.thickness > 0
          ? anatomy.tets.positions.size() + 4 * (surface.triangles.size() + anatomy.segments.size())
          : 0;
  return std::max(features, of_thin);
}

/// Writes or reads (as `io` does) in a checkpoint the data of a body's contacts that the next tick starts
/// from. `features` is the number of features of the body's surface.
template <class Io>
void entry(Io& io, typename Io::template Entry<contact::ContactMemories>& memories, std::size_t features) {
  io.list(memories, most_memories, "contact", [&](auto& memory) {
    auto& [soft, body, feature, met, grip, force, normal, stiffness, rest] = memory;
    io.flag(soft, "with a soft body");
    io.number(body, "other body");
    io.number(feature, "feature");
    io.require(feature < features, "a contact of a nonexistent surface");
    io.number(met, "met feature");
    io.vector(grip, "grip");
    io.number(force, "force");
    io.vector(normal, "normal");
    io.number(stiffness, "stiffness");
    io.number(rest, "rest gap");
    io.require(contact::is_consistent(memory),
               "a contact without force or stiffness, or with a rest gap above 0");
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<contact::PadMemory>& pad, std::size_t rigid_bodies) {
  auto& [part, body, place, force, grip] = pad;
  io.number(part, "part of the hand");
  io.index(body, rigid_bodies, "pressed body");
  io.vector(place, "position");
  io.number(force, "force");
  for (auto& point : grip) io.vector(point, "grip");
  io.require(part >= 1 && part <= hand_joints && force > 0, "an invalid pad, or one that pulls");
}

/// Rigid and soft bodies of a scene. The hands' records in a checkpoint are checked against them.
struct GraspableBodies {
  const Model& model;
  std::span<const soft::SoftBody* const> tissues;

  bool can_be_held(BodyId body) const {
    const std::size_t rigid = model.rigid.size();
    return body < rigid ? model.rigid[body].setup.mass > 0 : body < rigid + tissues.size();
  }
  bool has_vertex(BodyId body, std::uint32_t vertex) const {
    const std::size_t rigid = model.rigid.size();
    return body < rigid || vertex < tissues[body - rigid]->anatomy().surface.positions.size();
  }
};

template <class Io>
void entry(Io& io, typename Io::template Entry<hands::Hold>& hold, const GraspableBodies& bodies) {
  auto& [body, points, lifted, resting_ticks] = hold;
  io.number(body, "held body");
  io.require(bodies.can_be_held(body), "a hold on a nonexistent or fixed body");
  io.list(points, hands::max_hold_points, "hold point", [&, &held = body](auto& point) {
    auto& [in_hand, in_body, vertex, stiffness, max_force] = point;
    io.vector(in_hand, "position in the hand");
    io.vector(in_body, "position in the body");
    io.number(vertex, "vertex");
    io.require(bodies.has_vertex(held, vertex), "a hold on a nonexistent vertex");
    io.number(stiffness, "stiffness");
    io.number(max_force, "largest force");
    io.require(stiffness > 0 && max_force > 0, "a hold without force");
  });
  io.flag(lifted, "lifted");
  io.number(resting_ticks, "resting ticks");
}

/// Writes or reads (as `io` does) a hand's state in a checkpoint, except its slot (index) in the rigid world.
template <class Io>
void entry(Io& io, typename Io::template Entry<hands::Hand>& hand, const GraspableBodies& bodies) {
  auto& [participant, side, slot, target, previous_target, target_flexion, flexion, draws, reaction, hold,
         pads] = hand;
  io.number(participant, "participant");
  io.index(side, 2, "side");
  io.pose(target, "target");
  io.pose(previous_target, "previous target");
  for (auto& f : target_flexion) io.number(f, "target flexion");
  for (auto& f : flexion) io.number(f, "flexion");
  io.flag(draws, "draws a cut");
  io.optional(reaction, "has an arm");
  if (reaction) io.number(*reaction, "reaction of the arm");
  io.require(!reaction || *reaction >= 0, "an arm that pushes with no force");
  io.list(pads, most_memories, "pad", [&](auto& pad) { entry(io, pad, bodies.model.rigid.size()); });
  io.optional(hold, "holds");
  if (hold) entry(io, *hold, bodies);
}

/// Writes or reads (as `io` does) a pair of soft bodies, the key of a map in a checkpoint. Both indices are
/// below `soft_bodies`, the lower one first.
template <class Io>
void pair_entry(Io& io, typename Io::template Entry<std::pair<std::size_t, std::size_t>>& bodies,
                std::size_t soft_bodies) {
  io.index(bodies.first, soft_bodies, "first body");
  io.index(bodies.second, soft_bodies, "second body");
  io.require(bodies.first <= bodies.second, "a pair of bodies in the wrong order");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<LayerSides>& sides, std::size_t soft_bodies) {
  io.map(sides, soft_bodies * soft_bodies, "layers", [&](auto& bodies, auto& list) {
    pair_entry(io, bodies, soft_bodies);
    io.list(list, most_layer_sides, "side", [&](auto& side) {
      auto& [a, b, normal] = side;
      io.number(a, "first feature");
      io.number(b, "second feature");
      io.vector(normal, "normal");
    });
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<Entanglements>& entangled, std::size_t soft_bodies) {
  io.map(entangled, soft_bodies * soft_bodies, "entanglement", [&](auto& bodies, auto& how) {
    pair_entry(io, bodies, soft_bodies);
    io.require(bodies.first < bodies.second, "a body entangled with itself");
    auto& [way, whole, seconds] = how;
    io.vector(way, "direction");
    io.flag(whole, "whole");
    io.number(seconds, "seconds");
    io.require(seconds >= 0, "bodies entangled for a negative time");
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<coupled::Lingerers::Map>& watched,
           const GraspableBodies& bodies) {
  const std::size_t rigid = bodies.model.rigid.size(), count = rigid + bodies.tissues.size();
  io.map(watched, count, "lingering body", [&](auto& body, auto& how) {
    io.number(body, "body");
    io.require(body < count, "a nonexistent lingering body");
    auto& [place, ticks] = how;
    io.vector(place, body < rigid ? coupled::pose_numbers : 3 * bodies.tissues[body - rigid]->nodes(),
              "positions");
    io.number(ticks, "ticks");
    io.require(ticks >= 0, "a body that lingers for a negative time");
  });
}

template <class Io>
void entry(Io& io, typename Io::template Entry<Part>& part) {
  auto& [attached, hidden, lit, inspected, opacity, stiffness, shape] = part;
  io.flag(attached, "attached");
  io.flag(hidden, "hidden");
  io.flag(lit, "lit");
  io.flag(inspected, "inspected");
  io.number(opacity, "opacity");
  io.require(opacity >= 0 && opacity <= 1, "an opacity beyond 0 to 1");
  io.number(stiffness, "stiffness");
  io.require(stiffness >= min_stiffness && stiffness <= max_stiffness, "a stiffness out of range");
  for (int k = 0; k < 9; ++k) io.number(shape.A(k % 3, k / 3), "shape");
  io.vector(shape.p, "shape's position");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<std::map<BodyId, std::uint8_t>>& lost, std::size_t bodies) {
  io.map(lost, bodies, "lost body", [&](auto& body, auto& times) {
    io.number(body, "body");
    io.require(body < bodies, "a nonexistent lost body");
    io.number(times, "times");
  });
}

}  // namespace prosector
