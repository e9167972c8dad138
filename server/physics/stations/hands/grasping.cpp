#include "server/physics/stations/hands/grasping.h"

#include <algorithm>

#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

/// A body that a hand can hold, with the contact points.
struct Holdable {
  std::size_t body = 0;
  std::vector<hands::Touch> touches;
};

/// Returns the nearest of `count` bodies that may be touched and that the hand can hold, if it is nearer than
/// `reach` (m).
template <class MayTouch, class TouchesOf>
std::optional<Holdable> nearest_that_holds(std::size_t count, double reach, const MayTouch& may_be_touched,
                                           const TouchesOf& touches_of) {
  std::optional<Holdable> best;
  for (std::size_t body = 0; body < count; ++body) {
    if (!may_be_touched(body)) continue;
    std::vector<hands::Touch> touches = hands::holding_touches(touches_of(body));
    const auto nearest =
        std::min_element(touches.begin(), touches.end(),
                         [](const hands::Touch& a, const hands::Touch& b) { return a.gap < b.gap; });
    if (nearest == touches.end() || !(nearest->gap < reach)) continue;
    reach = nearest->gap;
    best = Holdable{body, std::move(touches)};
  }
  return best;
}

std::vector<hands::Touch> touches_of_rigid(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                           const hands::Hand& hand, BodyId body) {
  std::vector<hands::Touch> out;
  for (const hands::Feeler& f :
       hands::feelers(hand, bodies.model.hands[hand.side], bodies.rigid.motion(hand.slot).pose)) {
    const contact::Distance d =
        contact::distance_to(colliders[body], f.point, hands::grasp_reach_rigid + f.radius);
    if (d.value - f.radius < hands::grasp_reach_rigid)
      out.push_back({f.part, f.point - d.value * d.normal, d.normal, d.value - f.radius, 0});
  }
  return out;
}

std::vector<hands::Touch> touches_of_soft(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                          const hands::Hand& hand, std::size_t body) {
  const Tissue& tissue = bodies.soft[body];
  const auto points =
      hands::feelers(hand, bodies.model.hands[hand.side], bodies.rigid.motion(hand.slot).pose);
  std::vector<hands::Touch> out;
  tissue.surface.vertices().near(
      colliders[hand.slot], hands::grasp_reach_soft, [&](std::uint32_t vertex, const contact::Distance& d) {
        const Vec3& x = tissue.surface.vertices().positions()[vertex];
        out.push_back({hands::nearest_feeler(points, x).part, x, -d.normal, d.value, vertex});
      });
  return out;
}

/// Returns the hold on the nearest rigid body in reach, or on `only` if given.
std::optional<hands::Hold> reach_rigid(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                       const hands::Hand& hand, std::optional<BodyId> only = std::nullopt) {
  const auto near = nearest_that_holds(
      bodies.model.rigid.size(), hands::grasp_reach_rigid,
      [&](std::size_t body) {
        return (!only || body == *only) && bodies.rigid.dynamic(body) &&
               collision::may_touch(bodies.rigid.mask(hand.slot), bodies.rigid.mask(body));
      },
      [&](std::size_t body) { return touches_of_rigid(bodies, colliders, hand, static_cast<BodyId>(body)); });
  if (!near) return std::nullopt;
  return hands::hold_rigid(static_cast<BodyId>(near->body), bodies.model.rigid[near->body].setup.mass,
                           bodies.model.scene.hand, bodies.rigid.motion(hand.slot).pose,
                           bodies.rigid.motion(near->body).pose, hands::nearest_of_each_digit(near->touches),
                           bodies.model.h);
}

/// Returns the hold on the nearest soft body in reach, or on `only` if given.
std::optional<hands::Hold> reach_soft(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                      const hands::Hand& hand, std::optional<BodyId> only = std::nullopt) {
  auto near = nearest_that_holds(
      bodies.soft.size(), hands::grasp_reach_soft,
      [&](std::size_t body) {
        return (!only || bodies.soft_id(body) == *only) &&
               !bodies.parts[bodies.soft_id(body)].out_of_touch() &&
               may_meet(bodies.soft[body], colliders[hand.slot]);
      },
      [&](std::size_t body) { return touches_of_soft(bodies, colliders, hand, body); });
  if (!near) return std::nullopt;
  std::vector<hands::Touch>& touches = near->touches;
  std::sort(touches.begin(), touches.end(), [](const hands::Touch& a, const hands::Touch& b) {
    return std::pair(a.gap, a.vertex) < std::pair(b.gap, b.vertex);
  });
  touches.resize(std::min(touches.size(), hands::max_hold_points));
  hands::Hold hold;
  hold.body = bodies.soft_id(near->body);
  const Pose to_hand = bodies.rigid.motion(hand.slot).pose.inverse();
  for (const hands::Touch& touch : touches)
    hold.points.push_back({to_hand * touch.point, Vec3::Zero(), touch.vertex,
                           bodies.soft[near->body].contact_stiffness(touch.vertex),
                           bodies.model.scene.hand.max_force / static_cast<double>(touches.size())});
  return hold;
}

std::optional<hands::Hold> reach(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                 const hands::Hand& hand, BodyId body) {
  if (body >= bodies.count()) return std::nullopt;
  return bodies.is_soft(body) ? reach_soft(bodies, colliders, hand, body)
                              : reach_rigid(bodies, colliders, hand, body);
}

/// Sets the hand's hold, if any, and wakes the held body or disables its collisions with the hand.
void take_hold(Bodies& bodies, hands::Hand& hand, std::optional<hands::Hold> hold) {
  if (!hold) return;
  hand.hold = std::move(hold);
  if (bodies.is_soft(hand.hold->body))
    bodies.soft[bodies.soft_index(hand.hold->body)].wake();
  else
    bodies.rigid.set_collides(hand.slot, hand.hold->body, false);
}

}  // namespace

void grasp(State& state, Colliders& colliders, hands::Hand& hand, std::optional<BodyId> wanted) {
  Bodies& bodies = state.bodies;
  if (hand.hold) return;
  refresh(colliders, bodies, state.hands, state.dissection.blades);
  std::optional<hands::Hold> hold = wanted ? reach(bodies, colliders, hand, *wanted) : std::nullopt;
  if (!hold) hold = reach_rigid(bodies, colliders, hand);
  if (!hold) hold = reach_soft(bodies, colliders, hand);
  take_hold(bodies, hand, std::move(hold));
}

void grasp_only(State& state, Colliders& colliders, hands::Hand& hand, BodyId wanted) {
  if (hand.hold) return;
  refresh(colliders, state.bodies, state.hands, state.dissection.blades);
  take_hold(state.bodies, hand, reach(state.bodies, colliders, hand, wanted));
}

}  // namespace prosector
