#include "server/physics/mechanics/hands/hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "common/hand.h"
#include "common/rotation.h"
#include "common/rotation_between.h"

namespace prosector::hands {
namespace {

// m: lever arm that converts the coupling's stiffness to an angular stiffness.
constexpr double turning_arm = 0.05;
constexpr double patch_radius = 0.015;  // m, of a digit's contact patch
// Times the coupling's force limit: a rigid hold breaks rather than stretches.
constexpr double grip_force = 4;
// Times the heavier of hand and body, over h²: tissue must not rotate a light tool in the hand.
constexpr double grip_stiffness = 10;
constexpr double max_turn = 0.5;  // rad per tick

Vec3 clamped(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(v * (limit / length)) : v;
}

}  // namespace

const Hand* hand_at(std::span<const Hand> hands, std::size_t slot) {
  for (const Hand& hand : hands)
    if (hand.slot == slot) return &hand;
  return nullptr;
}

bool is_held(std::span<const Hand> hands, BodyId body) {
  return std::any_of(hands.begin(), hands.end(),
                     [&](const Hand& hand) { return hand.hold && hand.hold->body == body; });
}

bool in_a_hand(std::span<const Hand> hands, BodyId body, std::span<const contact::Contact> touches) {
  return std::any_of(touches.begin(), touches.end(),
                     [&](const contact::Contact& c) { return hand_at(hands, c.b.body) != nullptr; }) ||
         is_held(hands, body);
}

Pull hand_pull(const Hand& hand, const HandModel& model, const HandDesc& desc, const Pose& centre, double h) {
  const Pose target = hand.target * model.center, previous = hand.previous_target * model.center;
  const double stiffness = hand.reaction ? arm_coupling : desc.stiffness;
  const double damping = 2 * std::sqrt(stiffness * desc.mass) / h;  // N/m, of a tick's displacement
  const double total = stiffness + damping, share = damping / total;
  const double reach = max_hand_speed * h;
  Pull pull;
  pull.translation =
      (1 - share) * clamped(target.p - centre.p, reach) + share * clamped(target.p - previous.p, reach);
  pull.rotation = (1 - share) * clamped(turn(centre.q, target.q), max_turn) +
                  share * clamped(turn(previous.q, target.q), max_turn);
  pull.stiffness = total;
  pull.max_force = desc.max_force;
  if (hand.reaction && !hand.hold)
    pull.max_force = std::min(desc.max_force, arm_allowance + arm_share * *hand.reaction);
  pull.angular_stiffness = total * turning_arm * turning_arm;
  pull.max_moment = desc.max_force * turning_arm;
  return pull;
}

Mat3 coupling_give(const Pose& centre, const Vec3& point) {
  const Vec3 r = point - centre.p;
  const Mat3 turned = r.squaredNorm() * Mat3::Identity() - r * r.transpose();
  return (Mat3::Identity() + turned / (turning_arm * turning_arm)) / arm_coupling;
}

std::vector<Feeler> feelers(const Hand& hand, const HandModel& model, const Pose& centre) {
  std::vector<Feeler> out;
  const Palm palm = hand_palm(hand.side);
  const double thickness = palm.half_extents.y();
  for (const double x : {-0.7, 0.0, 0.7})
    for (const double z : {-0.7, 0.0, 0.7})
      out.push_back({centre * Vec3(x * palm.half_extents.x(), 0, z * palm.half_extents.z()), thickness, 0});
  const auto poses = hand_part_poses(hand.side, hand.flexion, model.center);
  for (const HandSegment& s : hand_segments(hand.side))
    for (const double end : {-0.5, 0.5})
      out.push_back({centre * (poses[s.joint + 1] * Vec3(0, end * s.length, 0)), s.radius, s.joint + 1});
  return out;
}

const Feeler& nearest_feeler(std::span<const Feeler> feelers, const Vec3& point) {
  const Feeler* nearest = &feelers.front();
  double least = std::numeric_limits<double>::infinity();
  for (const Feeler& f : feelers) {
    const double gap = (point - f.point).norm() - f.radius;
    if (!(gap < least)) continue;
    nearest = &f;
    least = gap;
  }
  return *nearest;
}

Hold hold_rigid(BodyId body, double body_mass, const HandDesc& desc, const Pose& hand_centre,
                const Pose& body_centre, std::span<const Touch> touches, double h) {
  Hold hold;
  hold.body = body;
  const Pose to_hand = hand_centre.inverse(), to_body = body_centre.inverse();
  const double share = 1 / (3.0 * static_cast<double>(touches.size()));
  for (const Touch& touch : touches) {
    const Quat around = rotation_between(Vec3::UnitZ(), touch.normal);
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * std::numbers::pi / 3 * k;
      const Vec3 at = touch.point + patch_radius * (around * Vec3(std::cos(angle), std::sin(angle), 0));
      hold.points.push_back({to_hand * at, to_body * at, 0,
                             share * grip_stiffness * std::max(body_mass, desc.mass) / (h * h),
                             share * grip_force * desc.max_force});
    }
  }
  return hold;
}

}  // namespace prosector::hands
