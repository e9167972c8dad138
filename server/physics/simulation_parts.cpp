// What people make of the parts: who is in its place, who can be touched, how stiff tissue is.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "server/physics/simulation_impl.h"

namespace prosector {

bool Simulation::Impl::is_part(BodyId body) const {
  return is_soft(body) ? model.soft[soft_index(body)]->desc().part : model.scene.rigid[body].part;
}

const std::string& Simulation::Impl::name_of(BodyId body) const {
  return is_soft(body) ? model.soft[soft_index(body)]->desc().name : model.rigid[body].name;
}

/// Empty when the event was obeyed, else why not.
std::string Simulation::Impl::obey(const PartEvent& event) {
  using Kind = PartEvent::Kind;
  if (event.body >= parts.size()) return fmt::format("no body {}", event.body);
  if (!is_part(event.body)) return fmt::format("{} is no part of the anatomy", name_of(event.body));
  Part wanted = parts[event.body];
  switch (event.kind) {
    case Kind::detach:
      wanted.attached = false;
      break;
    case Kind::attach: {
      if (wanted.inspected) return "it is being inspected: end that first";
      const double away = wanted.attached ? 0 : distance_from_place(event.body);
      const double near_enough = is_soft(event.body) ? model.soft[soft_index(event.body)]->desc().snap
                                                     : model.scene.rigid[event.body].snap;
      if (away > near_enough)
        return fmt::format("{} is {:.1f} cm from its place: bring it within {:.1f} cm", name_of(event.body),
                           100 * away, 100 * near_enough);
      wanted.attached = true;
      break;
    }
    case Kind::inspect:
      if (!event.shape.A.allFinite() || !event.shape.p.allFinite() ||
          event.shape.A.cwiseAbs().maxCoeff() > most_shape)
        return "not a shape to show it in";
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
      if (!(event.value >= 0 && event.value <= 1)) return "opacity is from 0 to 1";
      wanted.opacity = event.value;
      break;
    case Kind::set_stiffness:
      if (!is_soft(event.body)) return fmt::format("{} is rigid", name_of(event.body));
      if (!(event.value >= least_stiffness && event.value <= most_stiffness))
        return fmt::format("stiffness is from {} to {} times the scene's", least_stiffness, most_stiffness);
      wanted.stiffness = event.value;
      break;
    case Kind::light:
      wanted.lit = event.value > 0;
      break;
  }
  make(event.body, wanted);
  return {};
}

/// How far the body's points are from where the scene puts them, root mean square, m: of tissue those that
/// are attached there, if any, weighed by how firmly.
double Simulation::Impl::distance_from_place(BodyId body) const {
  double sum = 0, weights = 0;
  if (!is_soft(body)) {
    const RigidModel& rigid = model.rigid[body];
    const Pose now = world.motion(body).pose * rigid.center.inverse();
    for (const Vec3& x : rigid.surface.positions) sum += (now * x - rigid.start * x).squaredNorm();
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, rigid.surface.positions.size())));
  }
  const std::size_t i = soft_index(body);
  const VecX& ties = model.soft[i]->attachment_stiffness();
  const bool free = ties.isZero();
  for (Eigen::Index n = 0; n < ties.size(); ++n) {
    const double weight = free ? 1 : ties[n];
    sum += weight * (soft[i].motion.x.segment<3>(3 * n) - equilibrium[i].segment<3>(3 * n)).squaredNorm();
    weights += weight;
  }
  return std::sqrt(sum / weights);
}

/// Makes the part so, and lets everybody feel it.
void Simulation::Impl::make(BodyId body, const Part& wanted) {
  const Part before = std::exchange(parts[body], wanted);
  const bool moves_otherwise = before.attached != wanted.attached ||
                               before.out_of_touch() != wanted.out_of_touch() ||
                               before.stiffness != wanted.stiffness;
  if (!moves_otherwise) return;
  if (is_soft(body)) {
    const std::size_t i = soft_index(body);
    if (wanted.out_of_touch()) {
      let_go_of(body, "it was taken out of touch");
      freeze(i);
    }
  } else {
    if (wanted.out_of_touch() || (wanted.attached && !before.attached))
      let_go_of(body, wanted.out_of_touch() ? "it was taken out of touch" : "it is back in its place");
    if (wanted.attached && !before.attached) {
      RigidMotion motion;
      motion.pose = model.rigid[body].start * model.rigid[body].center;
      world.set_motion(body, motion);
    }
  }
  take_effect(world, body);
  wake_everything();
}

/// What its part says of how a body takes part in `rigid_world`, and how a soft one is held and how stiff.
void Simulation::Impl::take_effect(RigidWorld& rigid_world, BodyId body) {
  const Part& part = parts[body];
  if (is_soft(body)) {
    model.soft[soft_index(body)]->set_in_force(part.stiffness, part.attached);
    stored[soft_index(body)].reset();
    return;
  }
  const bool held = part.attached && model.scene.rigid[body].part;
  rigid_world.set_presence(body, part.out_of_touch() ? BodyPresence::absent
                                 : held              ? BodyPresence::fixed
                                                     : BodyPresence::free);
}

void Simulation::Impl::freeze(std::size_t body) {
  SoftBodyState& state = soft[body];
  state.asleep = true;
  state.motion.v.setZero();
  state.warm_start.setZero();
  state.motion.has_history = false;
}

void Simulation::Impl::wake_everything() {
  for (std::size_t i = 0; i < soft.size(); ++i)
    if (!parts[soft_id(i)].out_of_touch()) wake_soft(i);
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot)
    if (world.dynamic(slot)) world.wake(slot);
}

void Simulation::Impl::let_go_of(BodyId body, const char* why) {
  for (Hand& hand : hands)
    if (hand.hold && hand.hold->body == body) release(hand, why);
}

}  // namespace prosector
