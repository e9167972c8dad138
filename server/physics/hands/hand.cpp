#include "server/physics/hands/hand.h"

#include <algorithm>
#include <cmath>

#include "common/hand.h"

namespace prosector {
namespace {

constexpr double lever = 0.05;         // m: turns the coupling's stiffness into an angular one
constexpr double grip_radius = 0.04;   // m: distance of the pinned points from the hand's centre
constexpr double grip_stiffness = 10;  // times the held mass over h²
constexpr double max_turn = 0.5;       // rad in one tick

Vec3 clamped(const Vec3& v, double limit) {
  const double length = v.norm();
  return length > limit ? Vec3(v * (limit / length)) : v;
}

/// The rotation vector that leads from a to b, room frame.
Vec3 turn(const Quat& a, const Quat& b) {
  Quat q = b * a.conjugate();
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const Eigen::AngleAxisd rotation(q);
  return rotation.angle() * rotation.axis();
}

}  // namespace

Pull hand_pull(const Hand& hand, const HandModel& model, const HandDesc& desc, const Pose& centre, double h) {
  const Pose target = hand.target * model.center, previous = hand.previous_target * model.center;
  const double damping = 2 * std::sqrt(desc.stiffness * desc.mass) / h;  // N/m, of a tick's displacement
  const double total = desc.stiffness + damping, share = damping / total;
  const double reach = max_hand_speed * h;
  Pull pull;
  pull.translation =
      (1 - share) * clamped(target.p - centre.p, reach) + share * clamped(target.p - previous.p, reach);
  pull.rotation = (1 - share) * clamped(turn(centre.q, target.q), max_turn) +
                  share * clamped(turn(previous.q, target.q), max_turn);
  pull.stiffness = total;
  pull.max_force = desc.max_force;
  pull.angular_stiffness = total * lever * lever;
  pull.max_moment = desc.max_force * lever;
  return pull;
}

std::vector<Feeler> feelers(const Hand& hand, const HandModel& model, const Pose& centre) {
  std::vector<Feeler> out;
  const Palm palm = hand_palm(hand.side);
  const double thickness = palm.half_extents.y();
  for (const double x : {-0.7, 0.0, 0.7})
    for (const double z : {-0.7, 0.0, 0.7})
      out.push_back({centre * Vec3(x * palm.half_extents.x(), 0, z * palm.half_extents.z()), thickness});
  const auto poses = hand_part_poses(hand.side, hand.flexion, model.center);
  for (const HandSegment& s : hand_segments(hand.side))
    for (const double end : {-0.5, 0.5})
      out.push_back({centre * (poses[s.joint + 1] * Vec3(0, end * s.length, 0)), s.radius});
  return out;
}

Hold hold_rigid(BodyId body, double body_mass, const HandDesc& desc, const Pose& hand_centre,
                const Pose& body_centre, double h) {
  Hold hold{body, {}};
  const Pose hand_in_body = body_centre.inverse() * hand_centre;
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    const Vec3 in_hand = grip_radius / std::sqrt(3.0) * corner;
    hold.points.push_back(
        {in_hand, hand_in_body * in_hand, 0, grip_stiffness * body_mass / (4 * h * h), desc.max_force});
  }
  return hold;
}

}  // namespace prosector
