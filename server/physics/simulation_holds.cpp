// What hands hold: how it comes to be, and how it ends without being let go: torn, or set down.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/coupled/potentials.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

// Set down is what was in the air and is carried by something else now, while the hand gives next to nothing.
constexpr double in_the_air = 0.3, on_something = 0.7;  // of its weight, carried by others than hands
constexpr double given_up = 0.3;                        // of its weight, carried or pulled by the hand
constexpr double resting_speed = 0.05;                  // m/s
constexpr double resting_seconds = 0.25;

/// A body that a hand can hold, and where.
struct Holdable {
  std::size_t body = 0;
  std::vector<Touch> touches;
};

/// Of `count` bodies that may be touched the one that is nearest of those that the hand can hold, nearer than
/// `reach`.
template <class MayTouch, class TouchesOf>
std::optional<Holdable> nearest_that_holds(std::size_t count, double reach, const MayTouch& may_be_touched,
                                           const TouchesOf& touches_of) {
  std::optional<Holdable> best;
  for (std::size_t body = 0; body < count; ++body) {
    if (!may_be_touched(body)) continue;
    std::vector<Touch> touches = holding_touches(touches_of(body));
    const auto nearest = std::min_element(touches.begin(), touches.end(),
                                          [](const Touch& a, const Touch& b) { return a.gap < b.gap; });
    if (nearest == touches.end() || !(nearest->gap < reach)) continue;
    reach = nearest->gap;
    best = Holdable{body, std::move(touches)};
  }
  return best;
}

}  // namespace

std::vector<Touch> Simulation::Impl::touches_of_rigid(const Hand& hand, BodyId body) const {
  std::vector<Touch> out;
  for (const Feeler& f : feelers(hand, model.hands[hand.side], world.motion(hand.slot).pose)) {
    const Distance d = distance_to(colliders[body], f.point, grasp_reach_rigid + f.radius);
    if (d.value - f.radius < grasp_reach_rigid)
      out.push_back({f.part, f.point - d.value * d.normal, d.normal, d.value - f.radius, 0});
  }
  return out;
}

std::vector<Touch> Simulation::Impl::touches_of_soft(const Hand& hand, std::size_t body) const {
  const auto points = feelers(hand, model.hands[hand.side], world.motion(hand.slot).pose);
  std::vector<Touch> out;
  surfaces[body].near(colliders[hand.slot], grasp_reach_soft, [&](std::uint32_t vertex, const Distance& d) {
    const Vec3& x = surfaces[body].positions()[vertex];
    out.push_back({nearest_feeler(points, x).part, x, -d.normal, d.value, vertex});
  });
  return out;
}

std::optional<Hold> Simulation::Impl::reach_rigid(const Hand& hand) const {
  const auto near = nearest_that_holds(
      model.rigid.size(), grasp_reach_rigid,
      [&](std::size_t body) {
        return world.dynamic(body) && may_touch(world.mask(hand.slot), world.mask(body));
      },
      [&](std::size_t body) { return touches_of_rigid(hand, static_cast<BodyId>(body)); });
  if (!near) return std::nullopt;
  return hold_rigid(static_cast<BodyId>(near->body), model.rigid[near->body].setup.mass, model.scene.hand,
                    world.motion(hand.slot).pose, world.motion(near->body).pose,
                    nearest_of_each_digit(near->touches), model.h);
}

std::optional<Hold> Simulation::Impl::reach_soft(const Hand& hand) {
  auto near = nearest_that_holds(
      soft.size(), grasp_reach_soft,
      [&](std::size_t body) {
        return !parts[soft_id(body)].out_of_touch() && may_meet(body, colliders[hand.slot]);
      },
      [&](std::size_t body) { return touches_of_soft(hand, body); });
  if (!near) return std::nullopt;
  std::vector<Touch>& touches = near->touches;
  std::sort(touches.begin(), touches.end(), [](const Touch& a, const Touch& b) {
    return std::pair(a.gap, a.vertex) < std::pair(b.gap, b.vertex);
  });
  touches.resize(std::min(touches.size(), max_hold_points));
  Hold hold;
  hold.body = soft_id(near->body);
  const Pose to_hand = world.motion(hand.slot).pose.inverse();
  for (const Touch& touch : touches)
    hold.points.push_back({to_hand * touch.point, Vec3::Zero(), touch.vertex,
                           model.contact_stiffness(near->body, touch.vertex),
                           model.scene.hand.max_force / static_cast<double>(touches.size())});
  return hold;
}

/// m, room frame.
Vec3 Simulation::Impl::place_of(const Hold& hold, const Hold::Point& point) const {
  return is_soft(hold.body) ? surfaces[soft_index(hold.body)].positions()[point.vertex]
                            : world.motion(hold.body).pose * point.in_body;
}

/// N, on the held body.
Vec3 Simulation::Impl::hold_force(const Hand& hand) const {
  Vec3 sum = Vec3::Zero();
  const Pose centre = world.motion(hand.slot).pose;
  for (const Hold::Point& p : hand.hold->points) {
    const Vec3 stretch = centre * p.in_hand - place_of(*hand.hold, p);
    sum += BoundedSpring{p.stiffness, p.max_force}.secant(stretch.norm()) * stretch;
  }
  return sum;
}

/// What is held is touched, also where the hand passes through it; the hold's force is the hand's.
void Simulation::Impl::add_hold(ContactSample& sample, const Hand& hand) const {
  const Hold& hold = *hand.hold;
  const Vec3 force = hold_force(hand);
  sample.force += force;
  sample.impulse += force.norm() * model.h;
  if (sample.touching) return;
  sample.touching = true;
  sample.body = hold.body;
  sample.point = Vec3::Zero();
  for (const Hold::Point& p : hold.points)
    sample.point += place_of(hold, p) / static_cast<double>(hold.points.size());
  if (force.norm() > 0) sample.normal = -force.normalized();
}

/// N: what everything but hands did to the body in this tick, along contacts' normals.
Vec3 Simulation::Impl::support(BodyId body) const {
  Vec3 sum = Vec3::Zero();
  const auto is_it = [&](const ContactSide& side) {
    return side.kind == ContactSide::Kind::soft ? soft_id(side.body) == body : side.body == body;
  };
  const auto is_hand = [&](const ContactSide& side) {
    return side.kind != ContactSide::Kind::soft && hand_at(side.body) != nullptr;
  };
  for (const Island& island : islands)
    for (const Contact& c : island.contacts) {
      if (is_it(c.a) && !is_hand(c.b)) sum += c.force * c.normal;
      if (is_it(c.b) && !is_hand(c.a)) sum -= c.force * c.normal;
    }
  return sum;
}

/// After the step. Takes note in the hold of what it needs to know next time.
bool Simulation::Impl::was_set_down(Hand& hand, const Vec3& force) {
  Hold& hold = *hand.hold;
  const bool tissue = is_soft(hold.body);
  const std::size_t i = tissue ? soft_index(hold.body) : 0;
  if (tissue ? model.soft[i]->attached() || !model.soft[i]->falls() : model.rigid[hold.body].setup.balanced)
    return false;
  const double mass = tissue ? model.soft[i]->total_mass() : model.rigid[hold.body].setup.mass;
  const double weight = mass * model.scene.gravity.norm();
  if (!(weight > 0)) return false;
  const Vec3 up = -model.scene.gravity.normalized();
  const double carried = support(hold.body).dot(up) / weight;
  if (carried < in_the_air) hold.lifted = true;
  const double given = force.dot(up) / weight;
  const double pulled = (force - force.dot(up) * up).norm() / weight;
  const double speed =
      tissue ? soft[i].motion.v.lpNorm<Eigen::Infinity>() : world.motion(hold.body).linear_velocity.norm();
  const bool rests = carried > on_something && given < given_up && pulled < given_up && speed < resting_speed;
  hold.resting_ticks = hold.lifted && rests ? hold.resting_ticks + 1 : 0;
  return hold.resting_ticks * model.h >= resting_seconds;
}

void Simulation::Impl::tend_holds() {
  for (Hand& hand : hands) {
    if (!hand.hold) continue;
    lost.erase(hand.hold->body);
    const Vec3 force = hold_force(hand);
    if (force.norm() > model.scene.hand.tear_force)
      release(hand, fmt::format("{} was torn away by {:.0f} N", name_of(hand.hold->body), force.norm()));
    else if (was_set_down(hand, force))
      release(hand, fmt::format("{} was set down", name_of(hand.hold->body)));
  }
}

}  // namespace prosector
