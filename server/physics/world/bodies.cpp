#include "server/physics/world/bodies.h"

#include "common/assert.h"

namespace prosector {

Bodies::Bodies(const Model& compiled, std::vector<CompiledTissue> tissues)
    : model(compiled),
      rigid(model.scene.gravity, rigid::room_sides(model.scene.room)),
      parts(initial_parts(model, tissues.size())) {
  for (const RigidModel& r : model.rigid) {
    rigid::RigidMotion motion;
    motion.pose = r.start * r.center;
    rigid.add(r.setup, motion);
  }
  for (BodyId body = 0; body < model.rigid.size(); ++body) take_effect(rigid, body);
  for (CompiledTissue& tissue : tissues)
    soft.emplace_back(soft.size(), std::move(tissue.solver), tissue.collision);
}

const std::string& Bodies::name_of(BodyId body) const {
  PROSECTOR_ASSERT(body < count());
  return is_soft(body) ? soft[soft_index(body)].desc().name : model.rigid[body].name;
}

bool Bodies::is_part(BodyId body) const {
  PROSECTOR_ASSERT(body < count());
  return is_soft(body) ? soft[soft_index(body)].desc().part : model.scene.rigid[body].part;
}

bool Bodies::may_meet(std::size_t a, std::size_t b) const {
  PROSECTOR_ASSERT(a < soft.size() && b < soft.size());
  if (parts[soft_id(a)].out_of_touch() || parts[soft_id(b)].out_of_touch()) return false;
  const contact::SoftCollision &first = soft[a].collision, &second = soft[b].collision;
  if (a == b) return first.with_itself;
  return first.fidelity != Fidelity::none && second.fidelity != Fidelity::none &&
         collision::may_touch(first.mask, second.mask);
}

void Bodies::take_effect(rigid::RigidWorld& world, BodyId body) {
  PROSECTOR_ASSERT(body < parts.size());
  const Part& part = parts[body];
  if (is_soft(body)) {
    soft[soft_index(body)].solver->set_in_force(part.stiffness, part.attached);
    soft[soft_index(body)].stored.reset();
    return;
  }
  const bool held = part.attached && model.scene.rigid[body].part;
  world.set_presence(body, part.out_of_touch() ? rigid::BodyPresence::absent
                           : held              ? rigid::BodyPresence::fixed
                                               : rigid::BodyPresence::free);
}

void Bodies::wake_everything() {
  for (std::size_t i = 0; i < soft.size(); ++i)
    if (!parts[soft_id(i)].out_of_touch()) soft[i].wake();
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot)
    if (rigid.dynamic(slot)) rigid.wake(slot);
}

Part initial_part(const Model& model, BodyId body) {
  Part out;
  out.hidden = body < model.rigid.size() && model.rigid[body].whole.has_value();
  return out;
}

std::vector<Part> initial_parts(const Model& model, std::size_t soft_bodies) {
  std::vector<Part> out;
  for (BodyId body = 0; body < model.rigid.size() + soft_bodies; ++body)
    out.push_back(initial_part(model, body));
  return out;
}

}  // namespace prosector
