#include "server/physics/stations/hands/fingers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/assert.h"
#include "common/hand.h"
#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/mechanics/contact/rigid_contact_stiffness.h"
#include "server/physics/mechanics/hands/finger_drive.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

constexpr double probe = 1e-3;  // of flexion: step of finite differences
constexpr double give = 0.5;  // of a contact's stiffness: series stiffness, as tissue yields within the tick
constexpr double finger_margin = 0.02;  // m: more than the finger motion in a tick
constexpr double farthest_way = 0.4;    // m per unit of flexion: more than any point of a finger moves
// Positions along a segment, as fractions of its length.
constexpr std::array<double, 5> along = {-0.5, -0.25, 0.0, 0.25, 0.5};

using FingerObstacles = std::array<std::vector<hands::Obstacle>, fingers>;

/// Current poses of the hand's parts, world frame, and the derivative of a part's points by the flexion of
/// its finger.
struct FingerPoses {
  std::vector<Pose> now, bent;
  FingerPoses(const hands::Hand& hand, const hands::HandModel& hand_model, const Pose& centre) {
    auto flexion = hand.flexion;
    now = hands::hand_part_poses(hand.side, flexion, hand_model.center);
    for (double& f : flexion) f += f < 0.5 ? probe : -probe;
    bent = hands::hand_part_poses(hand.side, flexion, hand_model.center);
    for (std::size_t part = 0; part < now.size(); ++part) {
      now[part] = centre * now[part];
      bent[part] = centre * bent[part];
    }
  }
  Vec3 way(std::size_t part, double flexion, const Vec3& point) const {
    return (bent[part] * (now[part].inverse() * point) - point) / (flexion < 0.5 ? probe : -probe);
  }
};

/// Contacts of a part of the hand with a rigid body in the last tick.
struct Pressed {
  double force = 0;  // N
  int points = 0;
};

Pressed pressed(const hands::Hand& hand, std::size_t part, BodyId body) {
  Pressed sum;
  for (const contact::PadMemory& pad : hand.pads) {
    if (pad.part != part || pad.body != body) continue;
    sum.force += pad.force;
    ++sum.points;
  }
  return sum;
}

/// Adds the deepest point of each segment with each rigid body. The force there is taken from the last tick's
/// contacts, since Bullet's shapes differ slightly (its boxes have rounded edges). With its held body the
/// hand has no contacts, so there the depth is used.
void add_rigid_obstacles(const Bodies& bodies, std::span<const contact::Collider> colliders,
                         const hands::Hand& hand, const FingerPoses& poses, FingerObstacles& out) {
  const auto [lo, hi] = bodies.rigid.bounds(hand.slot, finger_margin);
  for (BodyId body = 0; body < bodies.model.rigid.size(); ++body) {
    const contact::Collider& collider = colliders[body];
    if (!collider.parts || !collision::may_touch(bodies.rigid.mask(hand.slot), bodies.rigid.mask(body)))
      continue;
    if ((collider.lo.array() > hi.array()).any() || (collider.hi.array() < lo.array()).any()) continue;
    const double heaviest =
        std::max(bodies.model.scene.hand.mass, collider.fixed ? 0 : bodies.model.rigid[body].setup.mass);
    const double stiffness = contact::rigid_contact_stiffness(heaviest, bodies.model.h);
    for (const HandSegment& s : hand_segments(hand.side)) {
      const std::size_t part = s.joint + 1, finger = hands::digit_of(part);
      std::optional<hands::Obstacle> deepest;
      for (const double share : along) {
        const Vec3 at = poses.now[part] * Vec3(0, share * s.length, 0);
        const contact::Distance d = contact::distance_to(collider, at, finger_margin + s.radius);
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

/// Adds contacts with tissue, which yields, at gaps up to `margin` (m).
void add_soft_obstacles(const Bodies& bodies, std::span<const contact::Collider> colliders,
                        const hands::Hand& hand, const FingerPoses& poses, double margin,
                        FingerObstacles& out) {
  const auto points =
      hands::feelers(hand, bodies.model.hands[hand.side], bodies.rigid.motion(hand.slot).pose);
  const contact::Collider& own = colliders[hand.slot];
  std::vector<std::vector<contact::Contact>> contacts(bodies.soft.size());
  parallel_each(contacts.size(), [&](std::size_t i) {
    const Tissue& tissue = bodies.soft[i];
    if (bodies.parts[bodies.soft_id(tissue.index)].out_of_touch() || !may_meet(tissue, own)) return;
    add_contacts(tissue, own, margin, tissue.memories, bodies.model.h, contacts[i]);
  });
  for (const std::vector<contact::Contact>& of_tissue : contacts)
    for (const contact::Contact& c : of_tissue) {
      const std::size_t part = hands::nearest_feeler(points, c.point).part;
      if (part == 0) continue;
      const std::size_t finger = hands::digit_of(part);
      const double way = c.normal.dot(poses.way(part, hand.flexion[finger], c.point));
      PROSECTOR_ASSERT(std::abs(way) <= farthest_way);
      out[finger].push_back({c.gap, way, c.stiffness, give * c.stiffness});
    }
}

/// Returns the fingers' changes of flexion in this tick.
std::array<double, fingers> steps(const hands::Hand& hand, const FingerObstacles& obstacles,
                                  const HandDesc& desc, double h) {
  const hands::FingerDrive drive{.max_force = desc.max_force / fingers};
  std::array<double, fingers> out{};
  for (std::size_t f = 0; f < fingers; ++f) {
    const double tracked = std::clamp(hand.target_flexion[f], 0.0, 1.0);
    out[f] = hands::finger_step(tracked, hand.flexion[f], hands::max_finger_rate * h, obstacles[f], drive);
  }
  return out;
}

/// Returns the flexion of the fingers at the tick's end.
std::array<double, fingers> bent(const Bodies& bodies, std::span<const contact::Collider> colliders,
                                 const hands::Hand& hand) {
  FingerObstacles rigid;
  const FingerPoses poses(hand, bodies.model.hands[hand.side], bodies.rigid.motion(hand.slot).pose);
  // A haptic arm's stylus counts as a finger that rigid bodies don't bend, since the user's own fingers
  // yield.
  if (!hand.reaction) add_rigid_obstacles(bodies, colliders, hand, poses, rigid);
  // Tissue farther away than the fingers move does not resist, so the tissue nearby is tried first.
  std::array<double, fingers> flexion = hand.flexion;
  for (const double margin : {contact::contact_margin, finger_margin}) {
    FingerObstacles obstacles = rigid;
    add_soft_obstacles(bodies, colliders, hand, poses, margin, obstacles);
    const auto by = steps(hand, obstacles, bodies.model.scene.hand, bodies.model.h);
    const auto stays_near = [&](double step) { return std::abs(step) * farthest_way <= margin; };
    if (margin < finger_margin && !std::all_of(by.begin(), by.end(), stays_near)) continue;
    for (std::size_t f = 0; f < fingers; ++f)
      if (by[f] != 0) flexion[f] = std::clamp(hand.flexion[f] + by[f], 0.0, 1.0);
    break;
  }
  return flexion;
}

void set_flexion(Bodies& bodies, hands::Hand& hand, const std::array<double, fingers>& flexion) {
  if (flexion == hand.flexion) return;
  hand.flexion = flexion;
  const auto poses = hands::hand_part_poses(hand.side, hand.flexion, bodies.model.hands[hand.side].center);
  for (std::size_t part = 0; part < poses.size(); ++part)
    bodies.rigid.set_part_pose(hand.slot, part, poses[part]);
}

}  // namespace

void bend_fingers(State& state, Colliders& colliders) {
  const auto straight = [](const hands::Hand& hand) {
    const std::array<double, fingers> none{};
    return hand.flexion == none && hand.target_flexion == none;
  };
  if (std::all_of(state.hands.begin(), state.hands.end(), straight)) return;
  refresh(colliders, state.bodies, state.hands, state.dissection.blades);
  std::vector<std::array<double, fingers>> now(state.hands.size());
  parallel_each(now.size(), [&](std::size_t i) {
    const hands::Hand& hand = state.hands[i];
    now[i] = straight(hand) ? hand.flexion : bent(state.bodies, colliders, hand);
  });
  for (std::size_t i = 0; i < now.size(); ++i) set_flexion(state.bodies, state.hands[i], now[i]);
}

}  // namespace prosector
