#include "server/physics/stations/islands/recover_tangled.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/mechanics/contact/parting.h"
#include "server/physics/mechanics/coupled/recovery.h"
#include "server/physics/mechanics/soft/unfold.h"

namespace prosector {
namespace {

constexpr int tangle_check_ticks = 8;
constexpr double left_inside = 0.1;  // cells: contacts alone resolve overlaps up to this depth
constexpr int most_moves = 100;
constexpr double squeezing = 3;  // times the body's weight
// s: time for which bodies are led apart before they are separated.
constexpr double entangled_seconds = 0.75;

/// Returns the height of the lowest node along `up`, m.
double height_of_lowest(const VecX& x, const Vec3& up) {
  return (up.transpose() * x.reshaped(3, x.size() / 3)).minCoeff();
}

}  // namespace

bool is_being_led(const Entanglements& entangled, std::size_t body) {
  return std::any_of(entangled.begin(), entangled.end(), [&](const auto& entry) {
    return (entry.first.first == body || entry.first.second == body) &&
           entry.second.seconds < 2 * entangled_seconds;
  });
}

namespace {

bool is_in_a_hand(const State& state, const contact::SoftContacts& touching, std::size_t body) {
  return hands::in_a_hand(state.hands, state.bodies.soft_id(body), touching.with_rigid[body]);
}

/// Returns whether the body is between a hand and other tissue, or between held tissue and anything. The hand
/// then leaves no room for its rest shape.
bool is_jammed(const State& state, const contact::SoftContacts& touching, std::size_t body) {
  const bool in_hand = is_in_a_hand(state, touching, body);
  return std::any_of(touching.pairs.begin(), touching.pairs.end(), [&](const contact::SoftPair& pair) {
    return (pair.a == body || pair.b == body) && pair.a != pair.b &&
           (in_hand || is_in_a_hand(state, touching, pair.a + pair.b - body));
  });
}

/// Returns whether rigid bodies press the body against each other or its attachments, with more force than
/// its weight and other tissue. It then has no room for its rest shape. Pressing tissue leaves room, since it
/// yields.
bool is_squeezed(const Bodies& bodies, std::size_t body) {
  double by_rigid = 0, by_tissue = 0;
  // N: resultant of the rigid bodies' forces, which tissue and gravity balance.
  Vec3 unbalanced = Vec3::Zero();
  for (const contact::ContactMemory& m : bodies.soft[body].memories) {
    (m.soft ? by_tissue : by_rigid) += m.force;
    if (!m.soft) unbalanced += m.force * m.normal;
  }
  const double between = bodies.soft[body].solver->attached() ? by_rigid : by_rigid - unbalanced.norm();
  const double weight = bodies.soft[body].solver->total_mass() * bodies.model.scene.gravity.norm();
  return between > std::max(squeezing * weight, by_tissue);
}

/// Returns whether the body is deep in other tissue but can't be led out, because its inverted elements don't
/// define a direction.
bool is_blind(State& state, const contact::SoftContacts& touching, std::size_t body) {
  if (state.bodies.soft[body].inside_out().empty() || is_in_a_hand(state, touching, body)) return false;
  return std::any_of(touching.pairs.begin(), touching.pairs.end(), [&](const contact::SoftPair& pair) {
    if ((pair.a != body && pair.b != body) || pair.a == pair.b || state.entangled.contains({pair.a, pair.b}))
      return false;
    const contact::SoftSkin a = state.bodies.soft[pair.a].skin(), b = state.bodies.soft[pair.b].skin();
    if (!a.faces || !b.faces || a.skin > 0 || b.skin > 0 ||
        is_in_a_hand(state, touching, pair.a + pair.b - body))
      return false;
    return contact::is_deep(contact::find_immersion(a, b, {}, {}), contact::find_immersion(b, a, {}, {}),
                            std::min(a.cell, b.cell));
  });
}

/// Returns the obstacles to the body's rest shape: a hand, held tissue, squeezing bodies or, without
/// attachments, a rigid body. Other tissue yields, and is led out.
coupled::Surroundings surroundings_of(State& state, const contact::SoftContacts& touching, std::size_t body) {
  const std::vector<contact::Contact>& touches = touching.with_rigid[body];
  const bool borne = std::any_of(touches.begin(), touches.end(), [](const contact::Contact& c) {
    return c.b.kind == contact::ContactSide::Kind::rigid;
  });
  const bool met =
      std::any_of(touching.pairs.begin(), touching.pairs.end(),
                  [&](const contact::SoftPair& pair) { return pair.a == body || pair.b == body; });
  const bool jammed = is_jammed(state, touching, body);
  const bool crushed = jammed || is_in_a_hand(state, touching, body) || is_squeezed(state.bodies, body);
  return {.jammed = jammed,
          .crushed = crushed,
          .blind = is_blind(state, touching, body),
          .company = crushed || (borne && !state.bodies.soft[body].solver->attached()),
          .touched = met || !touches.empty()};
}

void report_reset(const Bodies& bodies, std::size_t body, const std::string& why, StepReport& report);
void place_unfolded(Bodies& bodies, std::size_t body, double lowest);
void make_room_for(State& state, const contact::SoftContacts& touching, std::size_t body,
                   std::vector<std::size_t>& unfolded, StepReport& report);
void disentangle(Bodies& bodies, std::size_t a, std::size_t b, StepReport& report);
void lift_out_rigid_bodies(State& state, std::size_t body, StepReport& report);

}  // namespace

void recover_tangled_bodies(State& state, std::vector<coupled::Island>& islands,
                            const contact::SoftContacts& touching, double h, StepReport& report) {
  if (state.time.tick % tangle_check_ticks != 0) return;
  std::vector<std::size_t> unfolded;
  for (coupled::Island& island : islands)
    for (coupled::SoftMember& s : island.soft) {
      const double lowest =
          height_of_lowest(s.state->motion.x, -state.bodies.model.scene.gravity.normalized());
      if (!coupled::unfold_if_tangled(s, surroundings_of(state, touching, s.index),
                                      state.bodies.soft[s.index].equilibrium, h, tangle_check_ticks))
        continue;
      place_unfolded(state.bodies, s.index, lowest);
      report_reset(state.bodies, s.index, s.note, report);
      unfolded.push_back(s.index);
    }
  for (std::size_t k = 0; k < unfolded.size(); ++k)
    make_room_for(state, touching, unfolded[k], unfolded, report);
  for (const std::size_t body : unfolded) lift_out_rigid_bodies(state, body, report);
  for (const auto& [pair, how] : state.entangled)
    if (how.seconds > entangled_seconds && !is_in_a_hand(state, touching, pair.first) &&
        !is_in_a_hand(state, touching, pair.second))
      disentangle(state.bodies, pair.first, pair.second, report);
}

namespace {

/// Overlap of two bodies: the vertices of each inside the other.
struct Overlap {
  contact::Immersion own, other;
  double deepest() const { return std::max(own.deepest, other.deepest); }
};

std::optional<Overlap> overlap_of(Bodies& bodies, std::size_t body, std::size_t other);
bool part_at_once(Bodies& bodies, std::size_t a, std::size_t b);
bool reset_to_rest(Bodies& bodies, std::size_t body, std::size_t other, StepReport& report);
void put_beside(Bodies& bodies, std::size_t body, std::size_t other);

void report_reset(const Bodies& bodies, std::size_t body, const std::string& why, StepReport& report) {
  BodyReport& row = report.bodies.emplace_back();
  row.body = bodies.soft[body].desc().name;
  row.reset = true;
  row.note = why;
}

/// Moves an unfolded body to its equilibrium, if it has attachments. Otherwise raises it so that its lowest
/// node is no lower than before.
void place_unfolded(Bodies& bodies, std::size_t body, double lowest) {
  VecX& x = bodies.soft[body].state.motion.x;
  const Vec3 up = -bodies.model.scene.gravity.normalized();
  if (bodies.soft[body].solver->attached())
    x = bodies.soft[body].equilibrium;
  else
    x += (std::max(0.0, lowest - height_of_lowest(x, up)) * up).replicate(x.size() / 3, 1);
  bodies.soft[body].follow_nodes();
}

bool may_overlap(const Bodies& bodies, std::size_t a, std::size_t b) {
  return bodies.may_meet(a, b) && bodies.soft[a].outer_box().overlaps(bodies.soft[b].outer_box());
}

/// Separates an unfolded body from other tissue that it may be in now. Forces that lead it out would crush it
/// again. Attached tissue that was pushed to the body's rest position would crush it, too. That tissue is
/// reset to its own rest position and added to `unfolded`, unless a hand touches or jams it.
void make_room_for(State& state, const contact::SoftContacts& touching, std::size_t body,
                   std::vector<std::size_t>& unfolded, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (std::size_t other = 0; other < bodies.soft.size(); ++other) {
    if (other == body || !may_overlap(bodies, body, other) || part_at_once(bodies, body, other) ||
        !overlap_of(bodies, body, other) || is_jammed(state, touching, other) ||
        is_in_a_hand(state, touching, other))
      continue;
    if (reset_to_rest(bodies, other, body, report)) unfolded.push_back(other);
  }
}

/// Moves one body next to the other, as a whole: a free one, the lighter of two free ones. Returns false if
/// neither is free.
bool part_at_once(Bodies& bodies, std::size_t a, std::size_t b) {
  const auto ease = [&](std::size_t body) {
    return bodies.soft[body].solver->attached() ? 0 : 1 / bodies.soft[body].solver->total_mass();
  };
  if (ease(a) == 0 && ease(b) == 0) return false;
  if (ease(a) < ease(b)) std::swap(a, b);
  put_beside(bodies, a, b);
  return true;
}

/// Separates bodies that were not separated by being led.
void disentangle(Bodies& bodies, std::size_t a, std::size_t b, StepReport& report) {
  if (part_at_once(bodies, a, b)) {
    report_reset(bodies, a,
                 fmt::format("the body remained overlapping with {}: the two bodies were moved apart",
                             bodies.soft[b].desc().name),
                 report);
    return;
  }
  reset_to_rest(bodies, a, b, report);
  reset_to_rest(bodies, b, a, report);
}

/// Resets a body that can't leave the other one to its rest position and shape, and reports it. Returns false
/// if the body has hardly moved from there, because then the bodies overlap in the scene itself.
bool reset_to_rest(Bodies& bodies, std::size_t body, std::size_t other, StepReport& report) {
  const double moved =
      (bodies.soft[body].state.motion.x - bodies.soft[body].equilibrium).lpNorm<Eigen::Infinity>();
  if (moved < bodies.soft[body].desc().geometry.surface_cell) return false;
  soft::unfold(*bodies.soft[body].solver, bodies.soft[body].state);
  place_unfolded(bodies, body, 0);
  report_reset(bodies, body,
               fmt::format("the body remained overlapping with {}: it was moved to its rest position",
                           bodies.soft[other].desc().name),
               report);
  return true;
}

/// Returns the highest point of a box along `up`, m.
double top_of(const Vec3& lo, const Vec3& hi, const Vec3& up) {
  return up.dot(lo + hi) / 2 + up.cwiseAbs().dot(hi - lo) / 2;
}

/// Returns whether the rigid body's centre, or a point between it and the lowest point below it, is inside
/// the closed surface. `lo`, `hi`: the rigid body's bounds.
bool reaches_into(const contact::SoftSkin& skin, const Vec3& centre, const Vec3& lo, const Vec3& hi,
                  const Vec3& up) {
  const double down = up.dot(centre) + top_of(lo, hi, -up);
  for (const double share : {0.0, 0.5, 0.9}) {
    const Vec3 point = centre - share * down * up;
    if (skin.faces->nearest(point) && skin.faces->winding_number(point) >= 0.5) return true;
  }
  return false;
}

/// Moves free rigid bodies that reach into the unfolded body above it. A body that was crushed unfolds around
/// the weight that crushed it, and contacts can't separate them.
void lift_out_rigid_bodies(State& state, std::size_t body, StepReport& report) {
  Bodies& bodies = state.bodies;
  Tissue& tissue = bodies.soft[body];
  const contact::SoftSkin skin = tissue.skin();
  if (!skin.faces || skin.skin > 0 || bodies.model.scene.gravity.isZero()) return;
  const Vec3 up = -bodies.model.scene.gravity.normalized();
  const collision::Aabb box = tissue.outer_box();
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot) {
    if (!bodies.rigid.dynamic(slot) || hands::is_held(state.hands, static_cast<BodyId>(slot)) ||
        !collision::may_touch(bodies.rigid.mask(slot), tissue.collision.mask))
      continue;
    rigid::RigidMotion motion = bodies.rigid.motion(slot);
    const auto [lo, hi] = bodies.rigid.bounds(slot, contact::contact_margin);
    if (!reaches_into(skin, motion.pose.p, lo, hi, up)) continue;
    motion.pose.p += (top_of(box.lo, box.hi, up) + top_of(lo, hi, -up)) * up;
    motion.linear_velocity = motion.angular_velocity = Vec3::Zero();
    motion.asleep = false;
    bodies.rigid.set_motion(slot, motion);
    BodyReport& row = report.bodies.emplace_back();
    row.body = bodies.name_of(static_cast<BodyId>(slot));
    row.reset = true;
    row.note =
        fmt::format("the body was inside {}, which can't bear it: it was moved above it", tissue.desc().name);
  }
}

/// Returns how two closed solids overlap; nullopt for other bodies, and for overlaps that contacts alone
/// remove.
std::optional<Overlap> overlap_of(Bodies& bodies, std::size_t body, std::size_t other) {
  const contact::SoftSkin own = bodies.soft[body].skin(), others = bodies.soft[other].skin();
  if (!own.faces || !others.faces || own.skin > 0 || others.skin > 0) return std::nullopt;
  const auto &ruined = bodies.soft[body].inside_out(), &other_ruined = bodies.soft[other].inside_out();
  const Overlap overlap = {contact::find_immersion(own, others, ruined, other_ruined),
                           contact::find_immersion(others, own, other_ruined, ruined)};
  const double cell = std::min(bodies.soft[body].desc().geometry.surface_cell,
                               bodies.soft[other].desc().geometry.surface_cell);
  return overlap.deepest() < left_inside * cell ? std::nullopt : std::optional(overlap);
}

/// Returns the depth of the deepest overlap of the body with other tissue, m.
double deepest_in_tissue(Bodies& bodies, std::size_t body) {
  double deepest = 0;
  for (std::size_t other = 0; other < bodies.soft.size(); ++other) {
    if (other == body || !may_overlap(bodies, body, other)) continue;
    if (const auto overlap = overlap_of(bodies, body, other)) deepest = std::max(deepest, overlap->deepest());
  }
  return deepest;
}

/// Returns the direction in which the body leaves the other one, a unit vector. It never points down, because
/// the body rests on something.
Vec3 exit_direction(const Bodies& bodies, std::size_t body, std::size_t other, const Overlap& overlap) {
  const Vec3 up = -bodies.model.scene.gravity.normalized();
  Vec3 way = contact::way_apart(overlap.own, overlap.other,
                                bodies.soft[body].middle() - bodies.soft[other].middle());
  way -= std::min(0.0, way.dot(up)) * up;
  return way.norm() > 0 ? Vec3(way.normalized()) : up;
}

/// Moves a solid out of another, and on in that direction until it overlaps no tissue. Otherwise the next
/// piece of a heap would crush it again.
void put_beside(Bodies& bodies, std::size_t body, std::size_t other) {
  const auto overlap = overlap_of(bodies, body, other);
  if (!overlap) return;
  const Vec3 direction = exit_direction(bodies, body, other, *overlap);
  for (int moves = 0; moves < most_moves; ++moves) {
    const double deepest = deepest_in_tissue(bodies, body);
    if (deepest == 0) return;
    bodies.soft[body].state.motion.x += (deepest * direction).replicate(bodies.soft[body].solver->nodes(), 1);
    bodies.soft[body].state.motion.has_history = false;
    bodies.soft[body].state.asleep = false;
    bodies.soft[body].follow_nodes();
  }
}

}  // namespace

}  // namespace prosector
