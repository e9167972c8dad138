#include "client/app/desk/desk_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/hand.h"

namespace prosector {
namespace {

constexpr double least_reach = 0.12, most_reach = 4;  // m
constexpr double most_hover = 0.5,
                 least_hover = -0.03;  // m: the open hand presses down to 0.03 m below the surface
constexpr double clearance =
    0.025;  // m, between the surface and the joints and fingertips of a hovering hand
constexpr double most_retreat = 0.15;     // m, maximum retreat of the fingertips for clearance
constexpr double deepest_tool = -0.15;    // m, minimum hover height of an instrument's tip
constexpr double depth_in_soft = 0.008;   // m: penetration depth at a grasp
constexpr double short_of_rigid = 0.015;  // m: near enough to grasp, with room for the fingers to close
constexpr double tool_speed =
    0.4;  // m/s: speed at which the control point moves from the fingertips to an instrument's tip
constexpr double fastest_closed =
    0.8;  // m/s: limit of a closed hand, so that the held body isn't torn out of it
constexpr double open = 0.1, fist = 0.9;  // flexion
constexpr double close_per_s = 6;         // flexion per second when the hand closes
constexpr double max_blade_lag = 0.1;  // m: maximum distance between a blade's simulated hand and its target
constexpr double click = 0.4;          // s: maximum duration of a click
constexpr double reach_per_depth_notch = 0.01;  // m of reach() that correspond to one depth notch
const Vec3 fingertips_in_wrist{0, 0, -wrist_to_fingertips};

Vec3 at_most(const Vec3& step, double length) {
  const double norm = step.norm();
  return norm > length ? Vec3(length / norm * step) : step;
}

}  // namespace

void DeskHand::begin(const Ray& pointer, double reach) {
  reach_ = std::clamp(reach, least_reach, most_reach);
  point_ = pointer.from + reach_ * pointer.along;
}

void DeskHand::reach(double by) {
  if (!std::isfinite(by)) return;
  if (drawing_.is_pressed())
    drawing_.deepen(by / reach_per_depth_notch);
  else if (phase_ == Phase::grips && !has_tool_)
    drag_.pull(by);
  else if (!meets_)
    reach_ = std::clamp(reach_ + by, least_reach, most_reach);
  else if (phase_ == Phase::grips)
    tool_hover_ = std::clamp(tool_hover_ - by, deepest_tool, most_hover);
  else
    hover_ = std::clamp(hover_ - by, least_hover, most_hover);
}

void DeskHand::press() {
  button_ = true;
  approach_.begin();
  if (phase_ == Phase::grips && hold_.holds())
    drawing_.press();
  else
    phase_ = Phase::goes_in;
}

void DeskHand::let_go() {
  button_ = false;
  if (drawing_.is_pressed()) {
    const bool is_off_tissue = !drawing_.is_on_tissue();
    drawing_.release();
    if (is_off_tissue && approach_.seconds() < click) put_down();
  } else if (phase_ == Phase::grips && hold_.is_undecided()) {
    hold_.open_without_blade();
  } else if (phase_ != Phase::grips || !hold_.holds()) {
    put_down();
  }
}

void DeskHand::put_down() {
  if (phase_ == Phase::grips) wishes_.push_back(HandRequest::release);
  phase_ = Phase::hovers;
  tool_hover_ = first_hover;
  drag_.stop();
  hold_.release();
  carry_.put_down();
  drawing_.stop();
}

bool DeskHand::hovers() const {
  return phase_ == Phase::hovers && hover_ >= clearance;
}

std::optional<double> DeskHand::cut_depth() const {
  return hold_.holds() ? std::optional(drawing_.depth()) : std::nullopt;
}

std::vector<HandRequest> DeskHand::take_wishes() {
  return std::exchange(wishes_, {});
}

void DeskHand::advance(const HandGuide& guide, double seconds) {
  const double bend_to = is_closed() ? fist : open;
  flexion_ += std::clamp(bend_to - flexion_, -close_per_s * seconds, close_per_s * seconds);
  wrist_.face(guide.yaw);
  meets_ = guide.surface.has_value();
  const bool may_withdraw = hovers() && guide.surface && !guide.is_paused;
  withdrawal_.advance(may_withdraw, guide.physical, pose().p, seconds);
  if (phase_ != Phase::grips) wrist_.lift_fingers(guide.pitch, guide.level, seconds);
  follow_blade(guide, seconds);
  if (draw_blade(guide, seconds)) return;
  follow_tool(guide, seconds);
  const Vec3 to = guide.still ? point_ : target(guide);
  if (!to.allFinite()) return;
  const bool waits = hold_.holds() && guide.physical && (guide.physical->p - pose().p).norm() > max_blade_lag;
  if (waits) return;  // otherwise the simulated blade would take a shorter path through tissue
  const double most = (is_closed() ? fastest_closed : fastest_hand) * seconds;
  point_ += at_most(to - point_, hold_.holds() ? std::min(most, lookahead_distance) : most);
  if (phase_ == Phase::goes_in) grasp_when_reached(guide, to, seconds);
}

/// Updates whether a blade is in the hand. A blade stays there when the button is released.
void DeskHand::follow_blade(const HandGuide& guide, double seconds) {
  if (button_ && approach_.seconds() == 0) hold_.expect(guide.at_blade);
  approach_.pass(seconds);
  hold_.advance(is_closed(), guide.blade.has_value(), seconds);
  if (hold_.should_open(is_closed(), button_)) put_down();
  if (hold_.holds() && guide.blade && !button_ && !carry_.is_upright())
    carry_.set_upright(guide, pose().p, wrist_, seconds);
  if (phase_ != Phase::grips) wrist_.turn_back(seconds);
}

/// Lets the current cut drive the hand. Returns false if there is none.
bool DeskHand::draw_blade(const HandGuide& guide, double seconds) {
  cut_line_.clear();
  if (!hold_.holds() || !guide.blade) return false;
  const CutGuide cut{*guide.blade, guide.tissue, guide.find, guide.right, guide.physical};
  const auto led = drawing_.advance(cut, pose(), seconds);
  cut_line_ = drawing_.line(cut);
  if (!led || !is_finite(*led)) return false;
  wrist_.follow_cut(led->q);
  from_fingertips_ = guide.blade->tip - fingertips_in_wrist;
  point_ = *led * guide.blade->tip;
  return true;
}

/// Moves the control point smoothly from the fingertips to the tip of a grasped instrument, and back.
void DeskHand::follow_tool(const HandGuide& guide, double seconds) {
  has_tool_ = phase_ == Phase::grips && guide.tip;
  const Vec3 to = has_tool_ ? Vec3(*guide.tip - fingertips_in_wrist) : Vec3(Vec3::Zero());
  const Vec3 step = at_most(to - from_fingertips_, tool_speed * seconds);
  if (!step.allFinite()) return;
  from_fingertips_ += step;
  point_ += wrist_.rotation() * step;
}

/// Returns the target of point_. A blade passes over the surfaces on its way, unless the user has lowered the
/// tip with the wheel, in order to touch.
Vec3 DeskHand::target(const HandGuide& guide) {
  const Vec3 to = target_at_pointer(guide);
  if (!hold_.holds() || !guide.find || tool_hover_ < first_hover) return to;
  return carry_.over_tissue(guide, point_, to, button_);
}

/// Returns the target of point_ on the pointer's ray, and stores its distance for rays that hit nothing.
Vec3 DeskHand::target_at_pointer(const HandGuide& guide) {
  const bool drags = phase_ == Phase::grips && !has_tool_;
  if (drags) {
    reach_ = std::clamp(drag_.reach(guide, reach_), least_reach, most_reach);
  } else if (guide.surface) {
    double above = phase_ == Phase::grips ? tool_hover_ : hover_;
    if (phase_ == Phase::goes_in) above = std::min(hover_, guide.soft ? -depth_in_soft : short_of_rigid);
    double reach = *guide.surface - above;
    if (phase_ == Phase::hovers && hover_ >= clearance) reach -= required_retreat(guide, reach);
    reach_ = std::clamp(reach, least_reach, most_reach);
  }
  const Vec3 at = guide.pointer.from + reach_ * guide.pointer.along;
  drag_.set_anchor(drags ? at : point_);
  return at;
}

/// Returns the distance (m) by which the fingertips must stay nearer to the eye than `reach`, so that no
/// other part of a hovering hand touches the surface.
double DeskHand::required_retreat(const HandGuide& guide, double reach) const {
  double lacks = 0;
  if (!guide.gap) return lacks;
  const Pose wrist = pose_at(guide.pointer.from + reach * guide.pointer.along);
  const auto joints = hand_pose(right_hand, {});
  for (const HandSegment& segment : hand_segments(right_hand))
    for (const double along : {0.0, segment.length}) {
      const auto gap = guide.gap(wrist * (joints[segment.joint] * Vec3(0, 0, -along)));
      if (gap) lacks = std::max(lacks, clearance - *gap);
    }
  return std::min(lacks, most_retreat);
}

void DeskHand::grasp_when_reached(const HandGuide& guide, const Vec3& to, double seconds) {
  std::optional<double> distance;  // m, of the simulated hand from its target
  if (guide.physical) distance = (guide.physical->p - pose().p).norm();
  if (distance) approach_.count(*distance, seconds);
  if (!approach_.should_grasp((to - point_).norm() < target_tolerance, distance)) return;
  phase_ = Phase::grips;
  wishes_.push_back(HandRequest::grasp);
}

Pose DeskHand::pose() const {
  return pose_at(point_);
}

Pose DeskHand::pose_at(const Vec3& point) const {
  const Quat q = wrist_.rotation();
  return {point - q * (fingertips_in_wrist + from_fingertips_), q};
}

Vec3 DeskHand::fingertips() const {
  return pose() * fingertips_in_wrist;
}

}  // namespace prosector
