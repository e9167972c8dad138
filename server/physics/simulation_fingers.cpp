// Phase 1, fingers: they bend towards where they are tracked, and stop on what resists.

#include <algorithm>
#include <array>

#include "common/hand.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double probe = 1e-3;          // of flexion: for derivatives
constexpr double give = 0.5;            // of a contact's stiffness: tissue moves away within the tick
constexpr double finger_margin = 0.02;  // m: farther than a tick's bending
constexpr std::array<double, 5> along = {-0.5, -0.25, 0.0, 0.25, 0.5};  // of a segment

}  // namespace

/// The parts of the hand now, room frame, and how bending its finger by 1 moves a point of one.
struct Simulation::Impl::FingerPoses {
  std::vector<Pose> now, bent;
  FingerPoses(const Hand& hand, const HandModel& hand_model, const Pose& centre) {
    auto flexion = hand.flexion;
    now = hand_part_poses(hand.side, flexion, hand_model.center);
    for (double& f : flexion) f += f < 0.5 ? probe : -probe;
    bent = hand_part_poses(hand.side, flexion, hand_model.center);
    for (std::size_t part = 0; part < now.size(); ++part) {
      now[part] = centre * now[part];
      bent[part] = centre * bent[part];
    }
  }
  Vec3 way(std::size_t part, double flexion, const Vec3& point) const {
    return (bent[part] * (now[part].inverse() * point) - point) / (flexion < 0.5 ? probe : -probe);
  }
};

/// Of a part of the hand on a rigid body, in the last tick.
struct Pressed {
  double force = 0;  // N
  int points = 0;
};

Pressed pressed(const Hand& hand, std::size_t part, BodyId body) {
  Pressed sum;
  for (const PadMemory& pad : hand.pads) {
    if (pad.part != part || pad.body != body) continue;
    sum.force += pad.force;
    ++sum.points;
  }
  return sum;
}

/// Of each segment the deepest place in each rigid body. How hard it presses there the last tick's contacts
/// tell, for Bullet's shapes aren't quite ours: its boxes have round edges. What the hand holds it has no
/// contacts with: there, its depth does.
void Simulation::Impl::add_rigid_obstacles(const Hand& hand, const FingerPoses& poses,
                                           FingerObstacles& out) const {
  const auto [lo, hi] = world.bounds(hand.slot, finger_margin);
  for (BodyId body = 0; body < model.rigid.size(); ++body) {
    const Collider& collider = colliders[body];
    if (!collider.parts || !may_touch(world.mask(hand.slot), world.mask(body))) continue;
    if ((collider.lo.array() > hi.array()).any() || (collider.hi.array() < lo.array()).any()) continue;
    const double heaviest = std::max(model.scene.hand.mass, collider.fixed ? 0 : body_mass(body));
    const double stiffness = rigid_contact_factor * heaviest / (model.h * model.h);
    for (const HandSegment& s : hand_segments(hand.side)) {
      const std::size_t part = s.joint + 1, finger = digit_of(part);
      std::optional<Obstacle> deepest;
      for (const double share : along) {
        const Vec3 at = poses.now[part] * Vec3(0, share * s.length, 0);
        const Distance d = distance_to(collider, at, finger_margin + s.radius);
        const double gap = d.value - s.radius;
        if (gap > finger_margin || (deepest && gap >= deepest->gap)) continue;
        const Vec3 way = poses.way(part, hand.flexion[finger], at - s.radius * d.normal);
        deepest = {gap, -d.normal.dot(way), stiffness, stiffness};
      }
      if (!deepest) continue;
      if (!hand.hold || hand.hold->body != body) {
        const Pressed last = pressed(hand, part, body);
        if (last.points > 0) deepest->stiffness = deepest->series = last.points * stiffness;
        deepest->gap = last.points > 0 ? -last.force / deepest->stiffness : std::max(0.0, deepest->gap);
      }
      out[finger].push_back(*deepest);
    }
  }
}

/// Tissue: its contacts, which give way.
void Simulation::Impl::add_soft_obstacles(const Hand& hand, const FingerPoses& poses,
                                          FingerObstacles& out) const {
  const auto points = feelers(hand, model.hands[hand.side], world.motion(hand.slot).pose);
  for (std::size_t body = 0; body < soft.size(); ++body) {
    if (parts[soft_id(body)].out_of_touch() || !may_meet(body, colliders[hand.slot])) continue;
    std::vector<Contact> contacts;
    add_contacts(body, colliders[hand.slot], finger_margin, memories[body], contacts);
    for (const Contact& c : contacts) {
      const std::size_t part = nearest_feeler(points, c.point).part;
      if (part == 0) continue;
      const std::size_t finger = digit_of(part);
      const double way = c.normal.dot(poses.way(part, hand.flexion[finger], c.point));
      out[finger].push_back({c.gap, way, c.stiffness, give * c.stiffness});
    }
  }
}

void Simulation::Impl::bend_fingers() {
  const auto straight = [](const Hand& hand) {
    const std::array<double, fingers> none{};
    return hand.flexion == none && hand.target_flexion == none;
  };
  if (std::all_of(hands.begin(), hands.end(), straight)) return;
  refresh_colliders();
  for (Hand& hand : hands)
    if (!straight(hand)) bend(hand);
}

void Simulation::Impl::bend(Hand& hand) {
  FingerObstacles obstacles;
  const FingerPoses poses(hand, model.hands[hand.side], world.motion(hand.slot).pose);
  add_rigid_obstacles(hand, poses, obstacles);
  add_soft_obstacles(hand, poses, obstacles);
  const FingerDrive drive{.max_force = model.scene.hand.max_force / fingers};
  bool moved = false;
  for (std::size_t f = 0; f < fingers; ++f) {
    const double tracked = std::clamp(hand.target_flexion[f], 0.0, 1.0);
    const double step = finger_step(tracked, hand.flexion[f], max_finger_rate * model.h, obstacles[f], drive);
    hand.flexion[f] = std::clamp(hand.flexion[f] + step, 0.0, 1.0);
    moved = moved || step != 0;
  }
  if (!moved) return;
  const auto bent = hand_part_poses(hand.side, hand.flexion, model.hands[hand.side].center);
  for (std::size_t part = 0; part < bent.size(); ++part) world.set_part_pose(hand.slot, part, bent[part]);
}

}  // namespace prosector
