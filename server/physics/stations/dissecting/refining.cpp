#include "server/physics/stations/dissecting/refining.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "server/physics/base/freed_memory.h"
#include "server/physics/mechanics/soft/mesh_follower.h"
#include "server/physics/stations/dissecting/piece_builder.h"
#include "server/physics/stations/touching/fit_tissue.h"

namespace prosector {
namespace {

constexpr double places_apart = 0.25;       // of the smaller edge length: nearer points count as one
constexpr std::uint64_t settle_every = 10;  // ticks: interval of coarsening
/// Memory that refinement allocates per tetrahedron and tick, and the most of it to reserve in advance.
constexpr std::size_t bytes_a_tet = 8192, most_ahead = 96 << 20;

/// Returns whether contacts with this side cause refinement: hands, and rigid bodies that move.
bool is_followed(const contact::ContactSide& other, std::span<const KinematicTarget> kinematic_targets) {
  if (other.kind != contact::ContactSide::Kind::fixed) return other.kind == contact::ContactSide::Kind::rigid;
  return std::any_of(kinematic_targets.begin(), kinematic_targets.end(),
                     [&](const KinematicTarget& d) { return d.body == other.body; });
}

/// Appends the points where hands hold refinable bodies.
void add_held(const State& state, PlacesOfBodies& touched) {
  for (const hands::Hand& hand : state.hands) {
    if (!hand.hold || !state.bodies.is_soft(hand.hold->body)) continue;
    const std::size_t body = state.bodies.soft_index(hand.hold->body);
    const auto points = touched.find(body);
    if (points == touched.end()) continue;
    const std::vector<Vec3>& rest = state.bodies.soft[body].anatomy().surface.positions;
    for (const hands::Hold::Point& point : hand.hold->points) points->second.push_back(rest[point.vertex]);
  }
}

/// Returns whether the body is uncut and no blade is in it. An organ that was created for a blade that only
/// came near is moved back to the prepared organs.
bool is_uncut(organs::Dissection& dissection, std::size_t body) {
  const auto organ = dissection.organs.find(body);
  if (organ == dissection.organs.end()) return true;
  if (!organ->second.log().empty()) return false;
  for (const organs::Blade& blade : dissection.blades)
    for (const auto& [where, stroke] : blade.strokes)
      if (where.first == body) return false;
  dissection.uncut.insert(dissection.organs.extract(organ));
  return true;
}

/// Returns the body's state after the refinement steps. `like`: initial state of its current solver.
soft::SoftBodyState state_after(const soft::SoftBodyState& state, soft::SoftBodyState like,
                                const organs::RefinedBody& refined, const organs::PieceMesh& now,
                                std::span<const cutting::RefinementStep> steps) {
  const auto take = [&](const VecX& field, organs::Leaving leaving) {
    return organs::carried(field, refined.piece, now, steps, leaving);
  };
  soft::SoftBodyState out = state;
  out.motion.x = take(state.motion.x, organs::Leaving::nothing);
  out.motion.x_prev = take(state.motion.x_prev, organs::Leaving::nothing);
  out.motion.v = take(state.motion.v, organs::Leaving::momentum);
  out.motion.v_prev = take(state.motion.v_prev, organs::Leaving::momentum);
  out.warm_start = take(state.warm_start, organs::Leaving::nothing);
  out.history = organs::refined_history(state.history, refined.mesh.complex(), refined.piece, now, steps);
  // A child tetrahedron is flat, so that the history can't be transferred.
  if (out.history.size() != like.history.size()) out.history = std::move(like.history);
  out.asleep = false;
  out.quiet_ticks = 0;
  out.mode = std::move(like.mode);
  if (out.mode.size() > 0) out.omega = like.omega;
  return out;
}

/// Updates the body's solver and surface incrementally, or rebuilds the solver; both give the same result.
void take_along(State& state, std::size_t body, const organs::RefinedBody& refined,
                const organs::PieceMesh& now) {
  Tissue& tissue = state.bodies.soft[body];
  const organs::PieceEdit edit = organs::edit_between(refined.piece, now);
  if (organs::is_worth_following(edit) && tissue.solver->follower().can_follow(edit.mesh)) {
    tissue.solver->follower().follow(edit.mesh, organs::refined_embedding(refined, now));
    tissue.surface.rehang();
    return;
  }
  auto solver = same_tissue(state.bodies, body, tissue.desc(), organs::refined_anatomy(refined, now));
  contact::TissueSurface surface(solver->anatomy());
  place_piece(state, body, body, std::move(solver), {}, std::move(surface));
}

/// Applies refinement steps, which `refined` has taken in, to the body.
void take_effect(State& state, std::size_t body, organs::RefinedBody& refined,
                 std::span<const cutting::RefinementStep> steps) {
  if (steps.empty()) return;
  Bodies& bodies = state.bodies;
  Tissue& tissue = bodies.soft[body];
  organs::PieceMesh now = organs::refined_mesh(refined);
  const soft::SoftBodyState before = std::move(tissue.state);
  take_along(state, body, refined, now);
  tissue.state = state_after(before, tissue.solver->initial_state(), refined, now, steps);
  tissue.equilibrium = organs::refined_field(refined, now, state.dissection.uncut_equilibrium[body]);
  refined.piece = std::move(now);
  ++refined.rehung;
  if (refined.mesh.is_sparse()) {
    refined.mesh = refined.mesh.compacted(refined.whole.tets);
    refined.piece = organs::refined_mesh(refined);
  }
  if (!refined.mesh.any()) refined.touched = false;
  bodies.take_effect(bodies.rigid, bodies.soft_id(body));
  fit_to_mesh(state, body, {});
}

}  // namespace

void make_refinable(State& state) {
  std::size_t most = 0;  // largest possible number of tetrahedra
  for (const Tissue& tissue : state.bodies.soft) {
    if (tissue.desc().refinement.at == SoftDesc().refinement.at) continue;
    state.dissection.refined.try_emplace(tissue.index, *tissue.solver, state.bodies.model.scene.tick_rate);
    most +=
        tissue.anatomy().tets.tets.size() + static_cast<std::size_t>(tissue.desc().refinement.max_elements);
  }
  prefault_memory(std::min(bytes_a_tet * most, most_ahead));
}

PlacesOfBodies pressed_places(const State& state, std::span<const coupled::Island> islands,
                              std::span<const KinematicTarget> kinematic_targets) {
  PlacesOfBodies out;
  for (const auto& [body, refined] : state.dissection.refined) out[body];
  if (out.empty()) return out;
  const auto add = [&](const contact::ContactSide& side, const contact::ContactSide& other) {
    if (side.kind != contact::ContactSide::Kind::soft || !is_followed(other, kinematic_targets)) return;
    const auto points = out.find(side.body);
    if (points == out.end()) return;
    const VecX& rest = state.bodies.soft[side.body].solver->rest();
    Vec3 point = Vec3::Zero();
    for (std::size_t k = 0; k < side.nodes; ++k)
      point += side.weight[k] * rest.segment<3>(3 * Eigen::Index{side.node[k]});
    points->second.push_back(point);
  };
  for (const coupled::Island& island : islands)
    for (const contact::Contact& contact : island.contacts) {
      if (!(contact.force > 0)) continue;
      add(contact.a, contact.b);
      add(contact.b, contact.a);
    }
  return out;
}

void refine_touched(State& state, PlacesOfBodies places) {
  if (state.dissection.refined.empty()) return;
  add_held(state, places);
  for (auto& [body, refined] : state.dissection.refined) {
    const soft::SoftBodyState& now = state.bodies.soft[body].state;
    if ((places[body].empty() && !refined.mesh.any()) || now.recovering) continue;
    if (!is_uncut(state.dissection, body)) continue;
    const cutting::TouchedPlaces touched(std::move(places[body]), places_apart * refined.mesh.limits().edge);
    const bool resting = now.asleep && refined.touched && touched.empty();
    if (!resting) refined.touched = !touched.empty();
    const bool settle = state.time.tick % settle_every == 0;
    take_effect(state, body, refined, refined.mesh.follow(touched, resting, settle));
  }
}

void take_refinement_back(State& state, std::size_t body) {
  const auto refined = state.dissection.refined.find(body);
  if (refined == state.dissection.refined.end() || !refined->second.mesh.any()) return;
  take_effect(state, body, refined->second, refined->second.mesh.take_back());
}

const Anatomy& unrefined_anatomy(const State& state, std::size_t body) {
  const auto refined = state.dissection.refined.find(body);
  if (refined != state.dissection.refined.end() && refined->second.mesh.any()) return refined->second.whole;
  return state.bodies.soft[body].anatomy();
}

std::uint64_t topology_hash(const State& state, std::size_t body) {
  const auto refined = state.dissection.refined.find(body);
  if (refined != state.dissection.refined.end() && refined->second.mesh.any())
    return refined->second.content_hash;
  return state.bodies.soft[body].solver->content_hash();
}

}  // namespace prosector
