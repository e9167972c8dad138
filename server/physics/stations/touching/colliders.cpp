#include "server/physics/stations/touching/colliders.h"

#include <algorithm>
#include <tuple>

#include "server/physics/mechanics/contact/margins.h"

namespace prosector {
namespace {

const collision::RigidOutline* outline_at(const Model& model, std::size_t index) {
  if (model.outlines.empty()) return nullptr;
  const auto& outline = model.outlines[index];
  return outline ? &*outline : nullptr;
}

contact::Collider body_or_hand(const Bodies& bodies, std::size_t slot, const hands::Hand* hand) {
  const Model& model = bodies.model;
  const rigid::RigidWorld& world = bodies.rigid;
  contact::Collider c;
  const rigid::RigidMotion motion = world.motion(slot);
  const contact::RigidShape& shape = hand ? model.hands[hand->side].shape : model.rigid[slot].shape;
  c.slot = slot;
  c.pose = motion.pose;
  c.linear = motion.linear_velocity;
  c.angular = motion.angular_velocity;
  c.parts = &shape.parts;
  c.distances = &shape.distances;
  if (hand)
    c.part_poses = hands::hand_part_poses(hand->side, hand->flexion, model.hands[hand->side].center);
  else
    for (const collision::ShapePart& part : shape.parts) c.part_poses.push_back(part.pose);
  std::tie(c.lo, c.hi) = world.bounds(slot, 0);
  if (!hand) c.rolling_resistance = model.rigid[slot].setup.rolling_resistance;
  c.friction = hand ? model.scene.hand.friction : model.rigid[slot].setup.friction;
  c.fixed = !world.dynamic(slot);
  c.driven_to = world.driven_to(slot);
  c.mask = world.mask(slot);
  c.continuous = !hand && model.rigid[slot].setup.continuous;
  c.outline = outline_at(model, hand ? model.rigid.size() + hand->side : slot);
  if (hand)
    c.pull =
        std::min(contact::most_reach, ((hand->target * model.hands[hand->side].center).p - c.pose.p).norm());
  return c;
}

contact::Collider side_of_room(const Bodies& bodies, std::size_t side) {
  const Model& model = bodies.model;
  const contact::RigidShape& shape = model.room[side].shape;
  const collision::ShapePart& solid = shape.parts.front();
  contact::Collider c;
  c.slot = rigid::room_slot(side);
  c.parts = &shape.parts;
  c.distances = &shape.distances;
  c.part_poses = {solid.pose};
  c.lo = solid.pose.p - solid.half;
  c.hi = solid.pose.p + solid.half;
  c.friction = rigid::room_friction;
  c.fixed = true;
  c.mask = bodies.rigid.mask(c.slot);
  c.outline = outline_at(model, model.rigid.size() + model.hands.size() + side);
  return c;
}

}  // namespace

void refresh(Colliders& colliders, const Bodies& bodies, std::span<const hands::Hand> hands,
             std::span<const organs::Blade> blades) {
  const rigid::RigidWorld& world = bodies.rigid;
  colliders.assign(world.slots(), {});
  for (std::size_t slot = 0; slot < world.slots(); ++slot)
    if (world.used(slot) && world.presence(slot) != rigid::BodyPresence::absent)
      colliders[slot] = body_or_hand(bodies, slot, hands::hand_at(hands, slot));
  for (const organs::Blade& blade : blades) colliders[blade.slot].held_blade = true;
  for (std::size_t side = 0; side < bodies.model.room.size(); ++side)
    colliders.push_back(side_of_room(bodies, side));
}

double total_speed(const contact::Collider& c) {
  return c.linear.norm() + c.angular.norm() * (c.hi - c.lo).norm() / 2;
}

}  // namespace prosector
