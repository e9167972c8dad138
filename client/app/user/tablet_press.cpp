#include "client/app/user/tablet_press.h"

#include <algorithm>
#include <cmath>

#include "common/index_tip.h"
#include "common/panel.h"

namespace prosector {
namespace {

constexpr double max_pointing_flexion = 0.5;  // flexion below which an index finger points …
constexpr double min_flexion_difference =
    0.25;                          // … if the mean flexion of the other three is larger by this much
constexpr double farthest = 0.12;  // m, maximum apparent distance of a fingertip from the board
constexpr double hover = 0.03;     // m, height above the board of a finger that presses nothing
constexpr double beside = 0.01;    // m by which a pressing finger may leave its control
constexpr double slider_tolerance = 0.03;
constexpr double still = 0.012;  // m within which a finger counts as at rest

/// Returns the distance of a point outside a control's cap; 0: on it.
double off(const ControlDesc& control, const Vec3& at, double middle) {
  return std::max({std::abs(at.x() - middle) - control.half_width,
                   std::abs(at.y() - control.y) - control.half_height, 0.0});
}

bool points(const HandPose& hand) {
  const double others = (hand.flexion[2] + hand.flexion[3] + hand.flexion[4]) / 3;
  return hand.flexion[1] < max_pointing_flexion && others - hand.flexion[1] > min_flexion_difference;
}

/// Reports whether a point in the board's plane is on the board.
bool is_at_board(const Vec3& at) {
  return std::abs(at.x()) < panel_width / 2 && std::abs(at.y()) < panel_height / 2;
}

/// Returns the displacement of a hand that puts all its points in front of the board above it, in the board
/// frame. A point that the camera sees in front of the board can't be behind it, whatever its measured depth.
Vec3 board_clearance(std::size_t hand, const Pose& wrist, const HandPose& seen, const Vec3& eye) {
  const auto poses = hand_pose(hand, seen.flexion);
  Vec3 out = Vec3::Zero();
  for (const HandSegment& segment : hand_segments(hand)) {
    const Vec3 end = wrist * (poses[segment.joint] * Vec3(0, 0, -segment.length)), way = eye - end;
    const double lacks = hover + segment.radius - end.z();
    if (lacks <= out.z() || way.z() < 0.2 * way.norm()) continue;
    if (is_at_board(end - end.z() / way.z() * way)) out = lacks / way.z() * way;
  }
  return out;
}

/// Reports whether a finger that presses a control still does.
bool keeps(const ControlDesc& control, const Vec3& at) {
  if (control.kind == ControlKind::button) return off(control, at, control.x) < beside;
  return std::abs(at.y() - control.y) < slider_tolerance;
}

/// Returns the control at a point of the board. A slider's knob may be anywhere in its range.
std::optional<PanelControl> control_at(const Vec3& at) {
  for (const ControlDesc& control : panel_controls) {
    const double way = control.kind == ControlKind::slider ? control.travel / 2 : 0;
    if (off(control, at, std::clamp(at.x(), control.x - way, control.x + way)) <= 0) return control.control;
  }
  return std::nullopt;
}

}  // namespace

/// Updates the control under a finger, and presses it after the dwell time.
void TabletPress::aim(Finger& finger, const Vec3& at, std::int64_t time_ns) {
  if (finger.presses && keeps(describe(*finger.control), at)) return;
  const auto control = control_at(at);
  const bool stays = !finger.presses && control == finger.control && (at - finger.first).norm() < still;
  if (!stays) {
    finger.control = control;
    finger.since_ns = time_ns;
    finger.first = at;
    finger.presses = false;
  }
  finger.presses = control && 1e-9 * static_cast<double>(time_ns - finger.since_ns) >= dwell;
}

HandPose TabletPress::follow(std::size_t hand, const HandPose& seen, const Pose& tablet, const Vec3& eye,
                             std::int64_t time_ns) {
  Finger& finger = fingers_[hand];
  const double radius = hand_segments(hand)[index_end].radius;
  const Pose into = tablet.inverse();
  const Vec3 from = into * eye, tip = into * index_tip(hand, seen), along = tip - from;
  // Returns the ray's point at height `z` above the board.
  const auto at_height = [&](double z) -> Vec3 { return from + (z - from.z()) / along.z() * along; };
  const bool descends = from.z() > hover && along.z() < -0.2 * along.norm();
  const Vec3 at = descends ? at_height(radius) : Vec3(Vec3::Zero());
  const bool before = descends && (at - tip).dot(along.normalized()) < farthest && is_at_board(at);
  HandPose out = seen;
  if (!before || !points(seen)) {
    finger = {};
    out.pose.p += tablet.q * board_clearance(hand, into * seen.pose, seen, from);
    return out;
  }
  aim(finger, at, time_ns);
  double height = hover;
  if (finger.presses) {
    const ControlDesc& control = describe(*finger.control);
    height = control_face(control, control.kind == ControlKind::button ? 1 : 0).z();
  }
  out.pose.p += tablet.q * (at_height(height + radius) - tip);
  return out;
}

}  // namespace prosector
