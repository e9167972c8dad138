#include "client/app/tablet_press.h"

#include <algorithm>
#include <cmath>

#include "common/index_tip.h"
#include "common/panel.h"

namespace prosector {
namespace {

constexpr double straightest = 0.5;  // flexion up to which an index finger points …
constexpr double more_bent = 0.25;   // … where the other three are so much more bent
constexpr double farthest = 0.12;    // m that a fingertip may seem to be before the board
constexpr double hover = 0.03;       // m over the board that a finger is held which presses nothing
constexpr double beside = 0.01;      // m that one that presses may leave its control
constexpr double off_the_rail = 0.03;
constexpr double still = 0.012;  // m within which a finger stays

/// Returns how far an aim is outside a control's cap; 0: on it.
double off(const ControlDesc& control, const Vec3& at, double middle) {
  return std::max({std::abs(at.x() - middle) - control.half_width,
                   std::abs(at.y() - control.y) - control.half_height, 0.0});
}

bool points(const HandPose& hand) {
  const double others = (hand.flexion[2] + hand.flexion[3] + hand.flexion[4]) / 3;
  return hand.flexion[1] < straightest && others - hand.flexion[1] > more_bent;
}

/// Tells whether a place in the board's plane is on the board.
bool is_at_board(const Vec3& at) {
  return std::abs(at.x()) < panel_width / 2 && std::abs(at.y()) < panel_height / 2;
}

/// Returns by how much a hand is to move so that all of it that the eye sees before the board is over it. All
/// is in the board's frame. What a camera sees there can't be behind it, however deep it seems.
Vec3 off_the_board(std::size_t hand, const Pose& wrist, const HandPose& seen, const Vec3& eye) {
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

/// Tells whether a finger that presses a control still does.
bool keeps(const ControlDesc& control, const Vec3& at) {
  if (control.kind == ControlKind::button) return off(control, at, control.x) < beside;
  return std::abs(at.y() - control.y) < off_the_rail;
}

/// Returns the control at that place of the board. A slider's knob may be anywhere along its way.
std::optional<PanelControl> control_at(const Vec3& at) {
  for (const ControlDesc& control : panel_controls) {
    const double way = control.kind == ControlKind::slider ? control.travel / 2 : 0;
    if (off(control, at, std::clamp(at.x(), control.x - way, control.x + way)) <= 0) return control.control;
  }
  return std::nullopt;
}

}  // namespace

/// Follows where a finger is on the board, and presses what it has stayed at for long enough.
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
  // Where the ray is so high over the board.
  const auto at_height = [&](double z) -> Vec3 { return from + (z - from.z()) / along.z() * along; };
  const bool comes_down = from.z() > hover && along.z() < -0.2 * along.norm();
  const Vec3 at = comes_down ? at_height(radius) : Vec3(Vec3::Zero());
  const bool before = comes_down && (at - tip).dot(along.normalized()) < farthest && is_at_board(at);
  HandPose out = seen;
  if (!before || !points(seen)) {
    finger = {};
    out.pose.p += tablet.q * off_the_board(hand, into * seen.pose, seen, from);
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
