#include "server/physics/stations/parts/part_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/assert.h"
#include "server/physics/stations/hands/hands.h"

namespace prosector {
namespace {

/// Returns the root-mean-square distance of the body's points from their place in the scene, m. For tissue
/// only attached nodes count, if any, weighted by stiffness.
double distance_from_place(const Bodies& bodies, BodyId body) {
  double sum = 0, weights = 0;
  if (!bodies.is_soft(body)) {
    const RigidModel& rigid = bodies.model.rigid[body];
    const Pose now = bodies.rigid.motion(body).pose * rigid.center.inverse();
    for (const Vec3& x : rigid.surface.positions) sum += (now * x - rigid.start * x).squaredNorm();
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, rigid.surface.positions.size())));
  }
  const std::size_t i = bodies.soft_index(body);
  const VecX& ties = bodies.soft[i].solver->attachment_stiffness();
  const bool free = ties.isZero();
  for (Eigen::Index n = 0; n < ties.size(); ++n) {
    const double weight = free ? 1 : ties[n];
    sum += weight *
           (bodies.soft[i].state.motion.x.segment<3>(3 * n) - bodies.soft[i].equilibrium.segment<3>(3 * n))
               .squaredNorm();
    weights += weight;
  }
  return std::sqrt(sum / weights);
}

/// Sets the part's properties and updates bodies, hands and sleep states.
void change_part(State& state, BodyId body, const Part& wanted, StepReport& report) {
  Bodies& bodies = state.bodies;
  const Part before = std::exchange(bodies.parts[body], wanted);
  const bool moves_otherwise = before.attached != wanted.attached ||
                               before.out_of_touch() != wanted.out_of_touch() ||
                               before.stiffness != wanted.stiffness;
  if (!moves_otherwise) return;
  if (bodies.is_soft(body)) {
    if (wanted.out_of_touch()) {
      let_go_of(state, body, "the part was hidden or inspected, so it cannot be held", report);
      bodies.soft[bodies.soft_index(body)].freeze();
    }
  } else {
    if (wanted.out_of_touch() || (wanted.attached && !before.attached))
      let_go_of(state, body,
                wanted.out_of_touch() ? "the part was hidden or inspected, so it cannot be held"
                                      : "the part was attached again at its place",
                report);
    if (wanted.attached && !before.attached) {
      rigid::RigidMotion motion;
      motion.pose = bodies.model.rigid[body].start * bodies.model.rigid[body].center;
      bodies.rigid.set_motion(body, motion);
    }
  }
  bodies.take_effect(bodies.rigid, body);
  bodies.wake_everything();
}

}  // namespace

Refusal obey(State& state, const PartEvent& event, StepReport& report) {
  Bodies& bodies = state.bodies;
  PROSECTOR_ASSERT(bodies.parts.size() == bodies.count());
  using Kind = PartEvent::Kind;
  if (event.body >= bodies.parts.size()) return fmt::format("no body {}", event.body);
  if (!bodies.is_part(event.body))
    return fmt::format("{} is not part of the anatomy: it lacks anatomy = true", bodies.name_of(event.body));
  Part wanted = bodies.parts[event.body];
  switch (event.kind) {
    case Kind::detach:
      wanted.attached = false;
      break;
    case Kind::attach: {
      if (wanted.inspected) return "the part is being inspected: end the inspection before attaching it";
      const double away = wanted.attached ? 0 : distance_from_place(bodies, event.body);
      const double near_enough = bodies.is_soft(event.body)
                                     ? bodies.soft[bodies.soft_index(event.body)].solver->desc().snap
                                     : bodies.model.scene.rigid[event.body].snap;
      if (away > near_enough)
        return fmt::format("{} is {:.1f} cm from its original position: attach it within {:.1f} cm",
                           bodies.name_of(event.body), 100 * away, 100 * near_enough);
      wanted.attached = true;
      break;
    }
    case Kind::inspect:
      if (!event.shape.A.allFinite() || !event.shape.p.allFinite() ||
          event.shape.A.cwiseAbs().maxCoeff() > max_shape_entry)
        return "the pose or scale for the inspected part is not finite or too large";
      wanted.inspected = true;
      wanted.shape = event.shape;
      break;
    case Kind::end_inspect:
      wanted.inspected = false;
      wanted.shape = {};
      break;
    case Kind::hide:
      wanted.hidden = true;
      break;
    case Kind::show:
      wanted.hidden = false;
      break;
    case Kind::set_opacity:
      if (!(event.value >= 0 && event.value <= 1)) return "the part's opacity must be from 0 to 1";
      wanted.opacity = event.value;
      break;
    case Kind::set_stiffness:
      if (!bodies.is_soft(event.body)) return fmt::format("{} is rigid", bodies.name_of(event.body));
      if (!(event.value >= min_stiffness && event.value <= max_stiffness))
        return fmt::format("stiffness must be {} to {} times the scene file's", min_stiffness, max_stiffness);
      wanted.stiffness = event.value;
      break;
    case Kind::light:
      wanted.lit = event.value > 0;
      break;
  }
  change_part(state, event.body, wanted, report);
  return {};
}

void reset_body(State& state, BodyId body, StepReport& report) {
  Bodies& bodies = state.bodies;
  if (!bodies.is_soft(body)) {
    while (bodies.model.rigid[body].whole) body = static_cast<BodyId>(*bodies.model.rigid[body].whole);
    for (BodyId piece = body + 1; piece < bodies.model.rigid.size(); ++piece) {
      std::size_t root = piece;
      while (bodies.model.rigid[root].whole) root = *bodies.model.rigid[root].whole;
      if (root != body) continue;
      let_go_of(state, piece, "it was put back", report);
      change_part(state, piece, initial_part(bodies.model, piece), report);
    }
  }
  let_go_of(state, body, "it was put back", report);
  change_part(state, body, {}, report);
  bodies.lost.erase(body);
  put_at_start(bodies, body);
}

void put_at_start(Bodies& bodies, BodyId body) {
  PROSECTOR_ASSERT(body < bodies.count());
  if (!bodies.is_soft(body)) {
    rigid::RigidMotion motion;
    motion.pose = bodies.model.rigid[body].start * bodies.model.rigid[body].center;
    bodies.rigid.set_motion(body, motion);
    return;
  }
  Tissue& tissue = bodies.soft[bodies.soft_index(body)];
  const int steps_down = tissue.state.steps_down;  // the load of the server is unchanged
  tissue.state = tissue.solver->initial_state();
  tissue.state.steps_down = steps_down;
  tissue.state.motion.x = tissue.state.motion.x_prev = tissue.equilibrium;
  tissue.memories.clear();
  tissue.stored.reset();
  tissue.surface.place_vertices(tissue.state.motion.x);
}

}  // namespace prosector
