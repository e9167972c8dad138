#include "server/physics/stations/hands/reaching.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "common/rotation_between.h"
#include "server/physics/mechanics/contact/margins.h"
#include "server/physics/stations/hands/moving_capsule.h"

namespace prosector {
namespace {

/// A capsule of a hand or of a held body.
struct MovedPart {
  std::size_t slot = 0;
  Capsule shape;
  Pose in_hand;  // of the capsule, in the frame of the hand's centre
};

/// Returns the motion in a tick: the minimum of kinetic and coupling energy. `by_inertia`: motion without the
/// pull. `inertia`: mass or moment of inertia over h². `most`: largest force of the pull.
Vec3 free_motion(const Vec3& by_inertia, const Vec3& pull, double inertia, double stiffness, double most) {
  const Vec3 motion = (inertia * by_inertia + stiffness * pull) / (inertia + stiffness);
  const Vec3 force = inertia * (motion - by_inertia);
  return force.norm() > most ? Vec3(by_inertia + most / inertia * force.normalized()) : motion;
}

/// Returns the path of a hand that touches nothing.
HandPath free_path(const Bodies& bodies, const hands::Hand& hand, double h) {
  const hands::HandModel& model = bodies.model.hands[hand.side];
  const HandDesc& desc = bodies.model.scene.hand;
  const rigid::RigidMotion motion = bodies.rigid.motion(hand.slot);
  const hands::Pull pull = hands::hand_pull(hand, model, desc, motion.pose, h);
  HandPath path;
  path.centre = motion.pose;
  path.translation = free_motion(h * motion.linear_velocity, pull.translation, desc.mass / (h * h),
                                 pull.stiffness, pull.max_force);
  path.rotation = free_motion(h * motion.angular_velocity, pull.rotation,
                              model.setup.inertia.mean() / (h * h), pull.angular_stiffness, pull.max_moment);
  return path;
}

/// Adds the finger segments, and the palm as three strips.
void add_hand(const hands::Hand& hand, const hands::HandModel& model, std::vector<MovedPart>& out) {
  const auto poses = hands::hand_part_poses(hand.side, hand.flexion, model.center);
  for (const HandSegment& s : hand_segments(hand.side))
    out.push_back({hand.slot, {s.length, s.radius}, poses[s.joint + 1]});
  const Vec3 palm = hand_palm(hand.side).half_extents;
  const Quat along_z(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  for (const double side : {-1, 0, 1})
    out.push_back({hand.slot,
                   {2 * (palm.z() - palm.y()), palm.y()},
                   poses[0] * Pose{{side * (palm.x() - palm.y()), 0, 0}, along_z}});
}

/// Returns the four edges of a box along its longest axis, as the ends of each in the box's frame.
std::vector<std::pair<Vec3, Vec3>> long_edges(const Vec3& half) {
  Eigen::Index longest = 0;
  half.maxCoeff(&longest);
  std::vector<std::pair<Vec3, Vec3>> out;
  for (const double u : {-1, 1})
    for (const double v : {-1, 1}) {
      Vec3 end = half;
      end[(longest + 1) % 3] *= u;
      end[(longest + 2) % 3] *= v;
      Vec3 other = end;
      other[longest] = -end[longest];
      out.emplace_back(end, other);
    }
  return out;
}

/// Adds the parts of a held body.
void add_held(const contact::Collider& body, const Pose& centre, std::vector<MovedPart>& out) {
  const auto add = [&](const Vec3& from, const Vec3& to, double radius) {
    const Quat turned = from == to ? Quat::Identity() : rotation_between(Vec3::UnitY(), to - from);
    out.push_back(
        {body.slot, {(to - from).norm(), radius}, centre.inverse() * Pose{(from + to) / 2, turned}});
  };
  const Vec3 all = Vec3::Constant(std::numeric_limits<double>::infinity());
  for (const contact::Rod& rod : contact::rods_of(body, 0, -all, all)) add(rod.from, rod.to, rod.radius);
  for (std::size_t i = 0; i < body.parts->size(); ++i) {
    const collision::ShapePart& part = (*body.parts)[i];
    if (part.kind != collision::ShapeKind::box) continue;
    const Pose pose = body.pose * body.part_poses[i];
    for (const auto& [from, to] : long_edges(part.half)) add(pose * from, pose * to, 0);
  }
}

bool may_touch(const Bodies& bodies, const contact::Collider& body, const hands::Hand& hand,
               std::size_t slot) {
  return body.parts && body.slot != slot && !(hand.hold && hand.hold->body == body.slot) &&
         collision::may_touch(bodies.rigid.mask(slot), bodies.rigid.mask(body.slot));
}

void add_reached(const Bodies& bodies, std::span<const contact::Collider> colliders, const hands::Hand& hand,
                 const MovedPart& part, const HandPath& path, std::vector<rigid::RigidContact>& out) {
  // Pads have contacts at gaps up to the margin. Bullet finds contacts of boxes only where they overlap.
  const bool is_hand = part.slot == hand.slot;
  MovingCapsule mover(part.shape, part.in_hand, path, is_hand ? contact::contact_margin : 0);
  if (!mover.is_fast()) return;
  std::vector<const contact::Collider*> near;
  for (const contact::Collider& body : colliders.first(bodies.model.rigid.size()))
    if (may_touch(bodies, body, hand, part.slot) && mover.may_meet(body)) near.push_back(&body);
  for (const contact::Collider* body : near) mover.slide_along(*body);
  for (const contact::Collider* body : near)
    for (rigid::RigidContact& touch : mover.first_touch(*body)) {
      touch.a = part.slot;
      touch.b = body->slot;
      touch.part_a = touch.part_b = -1;                                 // no pad: friction acts at the point
      touch.friction = colliders[part.slot].friction * body->friction;  // combined as in Bullet
      out.push_back(touch);
    }
}

}  // namespace

std::vector<rigid::RigidContact> reached_bodies(const Bodies& bodies,
                                                std::span<const contact::Collider> colliders,
                                                std::span<const hands::Hand> hands, double h) {
  std::vector<rigid::RigidContact> out;
  for (const hands::Hand& hand : hands) {
    const HandPath path = free_path(bodies, hand, h);
    std::vector<MovedPart> parts;
    add_hand(hand, bodies.model.hands[hand.side], parts);
    if (hand.hold && !bodies.is_soft(hand.hold->body) && colliders[hand.hold->body].parts)
      add_held(colliders[hand.hold->body], path.centre, parts);
    for (const MovedPart& part : parts) add_reached(bodies, colliders, hand, part, path, out);
  }
  return out;
}

}  // namespace prosector
