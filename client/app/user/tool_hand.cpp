#include "client/app/user/tool_hand.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "client/view/held_bodies.h"
#include "common/error.h"
#include "common/hand.h"

namespace prosector {
namespace {

constexpr std::int64_t rest_time_ns =
    5'000'000'000;  // duration for which the hand rests without the instrument
constexpr std::int64_t lost_ns =
    400'000'000;  // after a longer loss the blade is carried to the instrument again
constexpr std::int64_t request_interval_ns = 500'000'000;  // until the command is repeated
constexpr double near_enough = 0.03;                       // m from the grasp pose, at which the hand grasps
constexpr double behind_tip = 0.09;  // m behind the tip: point at which the hand holds the shaft
constexpr double clearance = 0.12;   // m: height above the target at which the blade is carried
constexpr double carries = 0.7;      // m/s
constexpr double together = 0.01;    // m from the instrument, from which the blade follows it directly
constexpr double above = 0.02;  // m of horizontal distance within which the blade counts as above the target
constexpr double open_bend = 0.15, closed_bend = 0.8;  // flexion
const Vec3 hollow = {0, -0.03, -0.085};                // centre of the closed hand, m, wrist frame

/// Returns the instrument frame of a blade: origin at the tip, +z along the shaft, −y towards the edge.
Pose instrument_of(const BladeFrame& blade) {
  Mat3 axes;
  axes.col(2) = -blade.along;
  axes.col(1) = -blade.ahead;
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return {blade.tip, Quat(axes).normalized()};
}

/// Returns the wrist pose for grasping a lying blade: fingers along it, back of the hand up.
Pose wrist_over(const BladeFrame& blade) {
  const Vec3 back = -blade.along;
  const Vec3 about = std::abs(back.y()) < 0.9 ? Vec3::UnitY() : Vec3(-blade.ahead);
  Mat3 axes;
  axes.col(2) = back;
  axes.col(0) = about.cross(back).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  const Quat q = Quat(axes).normalized();
  return {blade.tip + behind_tip * back - q * hollow, q};
}

/// Returns the point reached from `from` towards `to` after a distance `way`, m: first up, then across, then
/// down.
Vec3 brought(const Vec3& from, const Vec3& to, double way) {
  const double high = to.y() + clearance, across = (to - from).cwiseProduct(Vec3(1, 0, 1)).norm();
  Vec3 next = to;
  if (across > above)
    next = from.y() < high ? Vec3(from.x(), high, from.z()) : Vec3(to.x(), from.y(), to.z());
  const Vec3 step = next - from;
  return step.norm() <= way ? next : Vec3(from + way * step.normalized());
}

}  // namespace

std::optional<ToolState> tool_state(const Replica& replica, const HandRef& hand, const std::string& name) {
  if (!replica.complete()) return std::nullopt;
  const double now = replica.time().shown_tick(std::numeric_limits<double>::infinity());
  std::vector<std::string> blades;
  for (BodyId id = 0; id < replica.scene()->bodies.size(); ++id) {
    const SceneBody& body = replica.scene()->bodies[id];
    const RigidReplica* rigid = replica.bodies().rigid(id);
    const auto blade = rigid != nullptr && body.moves ? blade_frame(*rigid) : std::nullopt;
    if (!blade) continue;
    blades.push_back(body.name);
    if (body.name != name) continue;
    ToolState out{id, replica.rigid_pose(id, now), *blade, std::nullopt, false};
    const auto user = replica.user(hand.participant, now);
    if (user && user->hands[hand.hand].tracked) out.wrist = user->hands[hand.hand].pose;
    const std::vector<BodyId> held = held_by(replica, hand);
    out.is_held = std::ranges::count(held, id) > 0;
    out.is_hindered = !out.is_held && !held.empty();
    return out;
  }
  throw InputError(
      fmt::format("tracker.stations.instrument.tool: the scene has no blade \"{}\"; {}", name,
                  blades.empty() ? "it has no blades" : fmt::format("it has {}", fmt::join(blades, ", "))));
}

HandPose ToolHand::follow(const ToolState& tool, const std::optional<Pose>& instrument, std::int64_t now_ns) {
  const double seconds =
      1e-9 * static_cast<double>(std::clamp<std::int64_t>(now_ns - now_ns_, 0, 100'000'000));
  now_ns_ = now_ns;
  if (instrument && last_ && now_ns - last_->time_ns > lost_ns) arrived_ = false;
  if (instrument) last_ = Seen{*instrument, now_ns};
  if (last_ && now_ns - last_->time_ns > rest_time_ns) last_.reset();
  HandPose hand;
  if (!last_) {
    wrist_tool_.reset();
    return hand;
  }
  hand.tracked = true;
  tool.is_held ? lead(tool, seconds, hand) : fetch(tool, hand);
  return hand;
}

/// Moves the hand to the blade and requests a grasp there. A hand that holds another body first releases it
/// in place.
void ToolHand::fetch(const ToolState& tool, HandPose& hand) {
  wrist_tool_.reset();
  hand.pose = tool.is_hindered && tool.wrist ? *tool.wrist : wrist_over(tool.pose * tool.blade);
  hand.flexion.fill(open_bend);
  const bool there = tool.wrist && (tool.wrist->p - hand.pose.p).norm() < near_enough;
  if (!(there || tool.is_hindered) || now_ns_ - wished_ns_ < request_interval_ns) return;
  wished_ns_ = now_ns_;
  wish_ = tool.is_hindered ? CommandBody(Release{right_hand}) : CommandBody(Grasp{right_hand, tool.body});
}

/// Carries the blade to the instrument, then follows the instrument.
void ToolHand::lead(const ToolState& tool, double seconds, HandPose& hand) {
  const Pose& wanted = last_->pose;
  const Pose body_instrument = instrument_of(tool.blade);
  if (!wrist_tool_) {
    if (!tool.wrist) return void(hand.tracked = false);
    wrist_tool_ = tool.wrist->inverse() * tool.pose;
    at_ = tool.pose * body_instrument;
    arrived_ = false;
  }
  if (!arrived_) {
    const double step = carries * seconds, way = (wanted.p - at_.p).norm();
    const double turned = way > step ? step / way : 1;
    at_ = {brought(at_.p, wanted.p, step), at_.q.slerp(turned, wanted.q)};
    arrived_ = (wanted.p - at_.p).norm() < together;
  }
  if (arrived_) at_ = wanted;
  hand.pose = at_ * body_instrument.inverse() * wrist_tool_->inverse();
  hand.flexion.fill(closed_bend);
}

std::optional<CommandBody> ToolHand::take_command() {
  return std::exchange(wish_, std::nullopt);
}

}  // namespace prosector
