#include "server/physics/stations/hands/holding.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

#include "server/physics/mechanics/contact/potentials.h"
#include "server/physics/mechanics/coupled/lever.h"
#include "server/physics/stations/hands/hands.h"

namespace prosector {
namespace {

// A body counts as set down if it was lifted and is now carried by something else, while the hand exerts
// almost no force.
constexpr double in_the_air = 0.3, on_something = 0.7;  // of its weight: support by others than hands
constexpr double given_up = 0.3;        // of its weight: force of the hand, upwards or sideways
constexpr double resting_speed = 0.05;  // m/s
constexpr double resting_seconds = 0.25;

/// Returns the normal contact forces on the body by everything except hands in this tick, N.
Vec3 support(const Bodies& bodies, std::span<const hands::Hand> hands,
             std::span<const coupled::Island> islands, BodyId body) {
  Vec3 sum = Vec3::Zero();
  const auto is_it = [&](const contact::ContactSide& side) {
    return side.kind == contact::ContactSide::Kind::soft ? bodies.soft_id(side.body) == body
                                                         : side.body == body;
  };
  const auto is_hand = [&](const contact::ContactSide& side) {
    return side.kind != contact::ContactSide::Kind::soft && hands::hand_at(hands, side.body) != nullptr;
  };
  for (const coupled::Island& island : islands)
    for (const contact::Contact& c : island.contacts) {
      if (is_it(c.a) && !is_hand(c.b)) sum += c.force * c.normal;
      if (is_it(c.b) && !is_hand(c.a)) sum -= c.force * c.normal;
    }
  return sum;
}

/// Returns whether the held body has been set down. Updates the counters in the hold.
bool was_set_down(const Bodies& bodies, std::span<const hands::Hand> hands,
                  std::span<const coupled::Island> islands, hands::Hand& hand, const Vec3& force) {
  hands::Hold& hold = *hand.hold;
  const bool tissue = bodies.is_soft(hold.body);
  const std::size_t i = tissue ? bodies.soft_index(hold.body) : 0;
  const Vec3& gravity = bodies.model.scene.gravity;
  if (tissue ? bodies.soft[i].solver->attached() : bodies.model.rigid[hold.body].setup.balanced) return false;
  const double weight = tissue ? bodies.soft[i].solver->total_mass() *
                                     bodies.soft[i].solver->weight(gravity, false).acceleration.norm()
                               : bodies.model.rigid[hold.body].setup.mass * gravity.norm();
  if (!(weight > 0)) return false;
  const Vec3 up = -gravity.normalized();
  const double carried = support(bodies, hands, islands, hold.body).dot(up) / weight;
  if (carried < in_the_air) hold.lifted = true;
  const double given = force.dot(up) / weight;
  const double pulled = (force - force.dot(up) * up).norm() / weight;
  const double speed = tissue ? bodies.soft[i].state.motion.v.lpNorm<Eigen::Infinity>()
                              : bodies.rigid.motion(hold.body).linear_velocity.norm();
  const bool rests = carried > on_something && given < given_up && pulled < given_up && speed < resting_speed;
  hold.resting_ticks = hold.lifted && rests ? hold.resting_ticks + 1 : 0;
  return hold.resting_ticks * bodies.model.h >= resting_seconds;
}

/// Returns the deviation of a body's point from the straight path of the solve in the tick's last part, m:
/// the point moved along an arc.
Vec3 off_the_straight(const rigid::RigidMotion& motion, const Vec3& at, double h) {
  const Vec3 turned = h * motion.angular_velocity;
  const Vec3 arm = at - motion.pose.p;
  const double angle = turned.norm();
  if (!(angle > 0)) return Vec3::Zero();
  const Vec3 arm_before = Eigen::AngleAxisd(-angle, turned / angle) * arm;
  return arm - (arm_before + turned.cross(arm_before));
}

/// Returns the pull of the hold in the last part of a tick, N. Excludes the gap between hand and body that a
/// fast rotation opens, because their points move along arcs around different centres.
Vec3 pull_of(const Bodies& bodies, const hands::Hand& hand, double h) {
  const bool tissue = bodies.is_soft(hand.hold->body);
  Vec3 sum = Vec3::Zero();
  for (HeldPoint p : held_points(bodies, hand)) {
    p.at_hand -= off_the_straight(bodies.rigid.motion(hand.slot), p.at_hand, h);
    if (!tissue) p.at_body -= off_the_straight(bodies.rigid.motion(hand.hold->body), p.at_body, h);
    sum += p.force();
  }
  return sum;
}

}  // namespace

Vec3 HeldPoint::force() const {
  const Vec3 stretch = at_hand - at_body;
  return contact::BoundedSpring{stiffness, max_force}.secant(stretch.norm()) * stretch;
}

std::vector<HeldPoint> held_points(const Bodies& bodies, const hands::Hand& hand) {
  const hands::Hold& hold = *hand.hold;
  const Pose centre = bodies.rigid.motion(hand.slot).pose;
  const bool tissue = bodies.is_soft(hold.body);
  const Pose body = tissue ? Pose() : bodies.rigid.motion(hold.body).pose;
  std::vector<HeldPoint> out;
  for (const hands::Hold::Point& p : hold.points) {
    const Vec3 at_body =
        tissue ? bodies.soft[bodies.soft_index(hold.body)].surface.vertices().positions()[p.vertex]
               : body * p.in_body;
    out.push_back({centre * p.in_hand, at_body, p.stiffness, p.max_force});
  }
  return out;
}

Vec3 hold_force(const Bodies& bodies, const hands::Hand& hand) {
  Vec3 sum = Vec3::Zero();
  for (const HeldPoint& p : held_points(bodies, hand)) sum += p.force();
  return sum;
}

Mat3 grip_give(const Bodies& bodies, const hands::Hand& hand, const Vec3& point) {
  coupled::Mat6 stiffness = coupled::Mat6::Zero();  // for twists about `point`
  for (const HeldPoint& p : held_points(bodies, hand)) {
    const coupled::Mat36 moved = coupled::lever(p.at_body - point);
    stiffness += p.stiffness * moved.transpose() * moved;
  }
  return stiffness.inverse().topLeftCorner<3, 3>();
}

void update_holds(State& state, std::span<const coupled::Island> islands, double h, StepReport& report) {
  Bodies& bodies = state.bodies;
  for (hands::Hand& hand : state.hands) {
    if (!hand.hold) continue;
    bodies.lost.erase(hand.hold->body);
    const Vec3 force = pull_of(bodies, hand, h);
    if (force.norm() > bodies.model.scene.hand.tear_force)
      release(bodies, hand,
              fmt::format("{} was torn away by {:.0f} N", bodies.name_of(hand.hold->body), force.norm()),
              report);
    else if (was_set_down(bodies, state.hands, islands, hand, force))
      release(bodies, hand, fmt::format("{} was set down", bodies.name_of(hand.hold->body)), report);
  }
}

void keep_holds(State& state, const std::vector<std::size_t>& pieces) {
  Bodies& bodies = state.bodies;
  for (hands::Hand& hand : state.hands) {
    if (!hand.hold || !bodies.is_soft(hand.hold->body)) continue;
    if (!std::binary_search(pieces.begin(), pieces.end(), bodies.soft_index(hand.hold->body))) continue;
    const Pose centre = bodies.rigid.motion(hand.slot).pose;
    struct Nearest {
      std::size_t body = 0;
      std::uint32_t vertex = 0;
      double distance = std::numeric_limits<double>::infinity();
    };
    std::vector<Nearest> found;
    for (const hands::Hold::Point& p : hand.hold->points) {
      Nearest& best = found.emplace_back();
      for (const std::size_t body : pieces) {
        const auto x = bodies.soft[body].surface.vertices().positions();
        for (std::uint32_t v = 0; v < x.size(); ++v)
          if (const double d = (x[v] - centre * p.in_hand).squaredNorm(); d < best.distance)
            best = {body, v, d};
      }
    }
    // A hand holds one body: the one with most points.
    std::map<std::size_t, std::size_t> points;
    for (const Nearest& n : found) ++points[n.body];
    const auto most = std::max_element(points.begin(), points.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    hands::Hold& hold = *hand.hold;
    hold.body = bodies.soft_id(most->first);
    std::vector<hands::Hold::Point> kept;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].body != most->first) continue;
      kept.push_back(hold.points[i]);
      kept.back().vertex = found[i].vertex;
    }
    hold.points = std::move(kept);
  }
}

void hand_over(Bodies& bodies, hands::Hand& hand, const RigidModel::Fracture& plane) {
  hands::Hold& hold = *hand.hold;
  const auto above = std::count_if(hold.points.begin(), hold.points.end(), [&](const hands::Hold::Point& p) {
    return plane.normal.dot(p.in_body - plane.point) > 0;
  });
  const std::size_t piece =
      2 * above >= static_cast<std::ptrdiff_t>(hold.points.size()) ? plane.above : plane.below;
  const Pose to_piece = bodies.rigid.motion(piece).pose.inverse() * bodies.rigid.motion(hold.body).pose;
  for (hands::Hold::Point& p : hold.points) p.in_body = to_piece * p.in_body;
  bodies.rigid.set_collides(hand.slot, hold.body, true);
  bodies.rigid.set_collides(hand.slot, piece, false);
  hold.body = static_cast<BodyId>(piece);
}

}  // namespace prosector
