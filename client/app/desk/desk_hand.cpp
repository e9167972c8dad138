#include "client/app/desk/desk_hand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
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
    0.8;                         // m/s: limit of a closed hand, so that the held body isn't torn out of it
constexpr double there = 0.005;  // m: tolerance of having reached the target
constexpr double physical_there = 0.03;    // m: tolerance for the simulated hand, which rests on surfaces
constexpr double stall_timeout = 0.5;      // s, timeout of a simulated hand that stops approaching its target
constexpr double approach_timeout = 3;     // s, timeout of a simulated hand that keeps approaching
constexpr double min_approach = 1e-3;      // m: smallest decrease of the distance that counts as approaching
constexpr double blocked_from = 0.08;      // m, between the simulated hand and its target
constexpr double blocked_radius = 0.02;    // m: a hand that moves less counts as blocked
constexpr double blocked_timeout = 1;      // s
constexpr double withdrawal_timeout = 10;  // s, in case a slow server does not remove the simulated hand
constexpr double min_press_time = 0.12;    // shorter clicks grasp nothing
constexpr double hand_yaw_offset = 1.0;    // rad about +y: fingers point ahead and to the left of the gaze
constexpr double across = 0.7;  // rad between the gaze and the fingers: the hand enters from below the frame
constexpr double lowest_lift = -0.6, highest_lift = 0.4;  // rad above the horizontal
constexpr double highest_over_level =
    -0.25;                         // rad, over a horizontal surface, where the wrist must not be below it
constexpr double lift_speed = 2;   // rad/s
constexpr double most_bend = 1.5;  // rad from the initial position, in either direction
constexpr double open = 0.1, fist = 0.9;  // flexion
constexpr double close_per_s = 6;         // flexion per second when the hand closes
constexpr double max_blade_lag = 0.1;  // m: maximum distance between a blade's simulated hand and its target
constexpr double upright_speed = 2;    // rad/s
constexpr double travel_clearance = 0.025, rotation_clearance = 0.12, lookahead_distance = 0.08,
                 probe_height = 0.3;       // m: clearance of a blade's tip above tissue, clearance while it
                                           // rotates, look-ahead distance, start height of the rays
constexpr double click = 0.4;              // s: maximum duration of a click
constexpr double hold_report_delay = 0.6;  // s, until the server has reported what a hand holds
constexpr double turn_back_per_s = 4;      // fraction per second by which the rotation due to cuts decays
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
    pull_ += by;
  else if (!meets_)
    reach_ = std::clamp(reach_ + by, least_reach, most_reach);
  else if (phase_ == Phase::grips)
    tool_hover_ = std::clamp(tool_hover_ - by, deepest_tool, most_hover);
  else
    hover_ = std::clamp(hover_ - by, least_hover, most_hover);
}

void DeskHand::turn(double roll, double bend) {
  if (!std::isfinite(roll) || !std::isfinite(bend)) return;
  roll_ = std::remainder(roll_ + roll, 2 * std::numbers::pi);
  bend_ = std::clamp(bend_ + bend, -most_bend, most_bend);
}

void DeskHand::press() {
  button_ = true;
  seconds_in_ = 0;
  waiting_ = {};
  if (phase_ == Phase::grips && has_blade_)
    drawing_.press();
  else
    phase_ = Phase::goes_in;
}

void DeskHand::let_go() {
  button_ = false;
  if (drawing_.is_pressed()) {
    const bool beside = !drawing_.is_on_tissue();
    drawing_.release();
    if (beside && seconds_in_ < click) put_down();
  } else if (phase_ == Phase::grips && takes_blade_ && !has_blade_ && seconds_held_ < hold_report_delay) {
    asks_to_release_ = true;
  } else if (phase_ != Phase::grips || !has_blade_) {
    put_down();
  }
}

void DeskHand::put_down() {
  if (phase_ == Phase::grips) wishes_.push_back(HandRequest::release);
  phase_ = Phase::hovers;
  tool_hover_ = first_hover;
  pull_ = 0;
  asks_to_release_ = has_blade_ = upright_ = false;
  drawing_.stop();
}

bool DeskHand::hovers() const {
  return phase_ == Phase::hovers && hover_ >= clearance;
}

std::optional<double> DeskHand::cut_depth() const {
  return has_blade_ ? std::optional(drawing_.depth()) : std::nullopt;
}

std::vector<HandRequest> DeskHand::take_wishes() {
  return std::exchange(wishes_, {});
}

void DeskHand::advance(const HandGuide& guide, double seconds) {
  const double bend_to = is_closed() ? fist : open;
  flexion_ += std::clamp(bend_to - flexion_, -close_per_s * seconds, close_per_s * seconds);
  yaw_ = guide.yaw + hand_yaw_offset;
  meets_ = guide.surface.has_value();
  withdraw_if_blocked(guide, seconds);
  lift_fingers(guide, seconds);
  follow_blade(guide, seconds);
  if (draw_blade(guide, seconds)) return;
  follow_tool(guide, seconds);
  const Vec3 to = guide.still ? point_ : over_tissue(guide, wanted(guide));
  if (!to.allFinite()) return;
  const bool waits = has_blade_ && guide.physical && (guide.physical->p - pose().p).norm() > max_blade_lag;
  if (waits) return;  // otherwise the simulated blade would take a shorter path through tissue
  const double most = (is_closed() ? fastest_closed : fastest_hand) * seconds;
  point_ += at_most(to - point_, has_blade_ ? std::min(most, lookahead_distance) : most);
  if (phase_ != Phase::goes_in) return;
  if (guide.physical) waiting_.count((guide.physical->p - pose().p).norm(), seconds);
  grasp_when_reached(guide, to);
}

/// Updates whether a blade is in the hand. A blade stays there when the button is released.
void DeskHand::follow_blade(const HandGuide& guide, double seconds) {
  if (button_ && seconds_in_ == 0) takes_blade_ = guide.at_blade;
  seconds_in_ += seconds;
  seconds_held_ = phase_ == Phase::grips ? seconds_held_ + seconds : 0;
  without_blade_ = guide.blade ? 0 : without_blade_ + std::min(seconds, longest_step);
  has_blade_ = phase_ == Phase::grips && (guide.blade || (has_blade_ && without_blade_ < hold_report_delay));
  if (has_blade_) asks_to_release_ = false;
  const bool is_lost = phase_ == Phase::grips && !button_ && !has_blade_ && !asks_to_release_;
  if (is_lost || (asks_to_release_ && seconds_held_ >= hold_report_delay)) put_down();
  if (has_blade_ && guide.blade && !button_ && !upright_) set_upright(guide, seconds);
  if (phase_ != Phase::grips)
    rotated_ = rotated_.slerp(std::min(1.0, turn_back_per_s * seconds), Quat::Identity());
}

/// Rotates a blade that was grasped in a lying position: tip down, edge to the right.
void DeskHand::set_upright(const HandGuide& guide, double seconds) {
  const Vec3 right = Vec3(guide.right.x(), 0, guide.right.z()).normalized();
  const bool is_up = guide.physical && (guide.physical->p - pose().p).norm() < physical_there;
  if (!right.allFinite() || over_ground_ < rotation_clearance - physical_there || !is_up) return;
  const Quat to = wrist_before_cuts().conjugate() * blade_rotation(*guide.blade, Vec3::UnitY(), right);
  rotated_ = rotated_towards(rotated_, to, upright_speed * std::min(seconds, longest_step));
  upright_ = rotated_.angularDistance(to) < 1e-6;
}

/// Returns the next target of a hovering blade on its way to `to`, high enough to pass over surfaces in
/// between. Does nothing if the user has lowered the tip with the wheel, in order to touch.
Vec3 DeskHand::over_tissue(const HandGuide& guide, const Vec3& to) {
  if (!has_blade_ || !guide.find || tool_hover_ < first_hover) return to;
  const Vec3 level(to.x() - point_.x(), 0, to.z() - point_.z());
  const double far = std::min(level.norm(), lookahead_distance);
  constexpr double nothing = -std::numeric_limits<double>::infinity();
  double highest = nothing;  // m, height of the highest surface ahead
  for (const double share : {0.0, 0.5, 1.0}) {
    const Vec3 over =
        point_ + (level.norm() > 0 ? share * far / level.norm() : 0) * level + probe_height * Vec3::UnitY();
    if (const auto below = guide.find({over, -Vec3::UnitY()}, std::nullopt))
      highest = std::max(highest, below->at.y());
  }
  over_ground_ = point_.y() - highest;
  const double needed = highest + (upright_ || button_ ? travel_clearance : rotation_clearance);
  if (point_.y() < needed - there) return {point_.x(), needed, point_.z()};
  Vec3 ahead = point_ + (level.norm() > far ? far / level.norm() : 1) *
                            (to - point_);  // limited to the distance that was checked
  ahead.y() = std::max(ahead.y(), needed);
  return ahead;
}

/// Lets the current cut drive the hand. Returns false if there is none.
bool DeskHand::draw_blade(const HandGuide& guide, double seconds) {
  cut_line_.clear();
  if (!has_blade_ || !guide.blade) return false;
  const CutGuide cut{*guide.blade, guide.tissue, guide.find, guide.right, guide.physical};
  const auto led = drawing_.advance(cut, pose(), seconds);
  cut_line_ = drawing_.line(cut);
  if (!led || !is_finite(*led)) return false;
  rotated_ = (wrist_before_cuts().conjugate() * led->q).normalized();
  from_fingertips_ = guide.blade->tip - fingertips_in_wrist;
  point_ = *led * guide.blade->tip;
  return true;
}

/// Rotates the fingers so that the hand covers little of the surface under it. A hand that holds something
/// isn't rotated.
void DeskHand::lift_fingers(const HandGuide& guide, double seconds) {
  if (phase_ == Phase::grips) return;
  const double level = std::clamp(guide.level, 0.0, 1.0);
  const double highest = level * highest_over_level + (1 - level) * highest_lift;
  const double to = std::clamp(across - guide.pitch, lowest_lift, highest);
  lift_ += std::clamp(to - lift_, -lift_speed * seconds, lift_speed * seconds);
}

/// Moves the control point smoothly from the fingertips to the tip of a grasped instrument, and back.
void DeskHand::follow_tool(const HandGuide& guide, double seconds) {
  has_tool_ = phase_ == Phase::grips && guide.tip;
  const Vec3 to = has_tool_ ? Vec3(*guide.tip - fingertips_in_wrist) : Vec3(Vec3::Zero());
  const Vec3 step = at_most(to - from_fingertips_, tool_speed * seconds);
  if (!step.allFinite()) return;
  from_fingertips_ += step;
  point_ += wrist() * step;
}

/// Returns the target of point_, and stores its distance for rays that hit nothing.
Vec3 DeskHand::wanted(const HandGuide& guide) {
  if (phase_ == Phase::grips && !has_tool_) return drag_target(guide);
  anchor_ = point_;
  if (guide.surface) {
    double above = phase_ == Phase::grips ? tool_hover_ : hover_;
    if (phase_ == Phase::goes_in) above = std::min(hover_, guide.soft ? -depth_in_soft : short_of_rigid);
    double reach = *guide.surface - above;
    if (phase_ == Phase::hovers && hover_ >= clearance) reach -= required_retreat(guide, reach);
    reach_ = std::clamp(reach, least_reach, most_reach);
  }
  return guide.pointer.from + reach_ * guide.pointer.along;
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

/// Returns the ray's intersection with the plane through the anchor parallel to the image plane, moved along
/// the ray by the pull.
Vec3 DeskHand::drag_target(const HandGuide& guide) {
  const double towards = -guide.pointer.along.dot(guide.back);
  const double depth = (guide.pointer.from - anchor_).dot(guide.back);
  const double reach = towards > 1e-3 ? depth / towards : reach_;
  reach_ = std::clamp(reach + std::exchange(pull_, 0), least_reach, most_reach);
  anchor_ = guide.pointer.from + reach_ * guide.pointer.along;
  return anchor_;
}

/// Counts the seconds in which the simulated hand does not approach its target. On a busy machine its updates
/// arrive late.
void DeskHand::Waiting::count(double distance, double passed) {
  const bool nearer = distance < nearest - min_approach;
  seconds = nearer ? 0 : seconds + passed;
  nearest = std::min(nearest, distance);
}

void DeskHand::Staying::count(const Vec3& physical, double passed) {
  const bool moved = !((physical - at).norm() < blocked_radius);
  seconds = moved ? 0 : seconds + passed;
  if (moved) at = physical;
}

/// Withdraws a hovering hand whose simulated hand is stuck, for instance behind an organ after the view was
/// rotated. The withdrawal ends when the server has removed the simulated hand or the button is pressed.
void DeskHand::withdraw_if_blocked(const HandGuide& guide, double seconds) {
  const bool may = hovers() && guide.surface && !guide.is_paused;
  if (withdrawn_) {
    seconds_withdrawn_ += seconds;
    withdrawn_ = may && guide.physical && seconds_withdrawn_ < withdrawal_timeout;
    return;
  }
  const bool is_near = !guide.physical || (guide.physical->p - pose().p).norm() < blocked_from;
  if (!may || is_near) {
    blocked_ = {};
    return;
  }
  blocked_.count(guide.physical->p, seconds);
  if (blocked_.seconds < blocked_timeout) return;
  blocked_ = {};
  withdrawn_ = true;
  seconds_withdrawn_ = 0;
}

void DeskHand::grasp_when_reached(const HandGuide& guide, const Vec3& to) {
  const bool in = (to - point_).norm() < there;
  const bool felt = guide.physical && (guide.physical->p - pose().p).norm() < physical_there;
  const double waited = guide.physical ? waiting_.seconds : seconds_in_;
  const bool enough = waited > stall_timeout || seconds_in_ > approach_timeout;
  if (seconds_in_ < min_press_time || !((in && felt) || enough)) return;
  phase_ = Phase::grips;
  wishes_.push_back(HandRequest::grasp);
}

Quat DeskHand::wrist() const {
  return wrist_before_cuts() * rotated_;
}

/// Returns the wrist rotation set by wheel and view.
Quat DeskHand::wrist_before_cuts() const {
  return Quat(Eigen::AngleAxisd(yaw_, Vec3::UnitY()) * Eigen::AngleAxisd(bend_, Vec3::UnitX()) *
              Eigen::AngleAxisd(-roll_, Vec3::UnitZ()) * Eigen::AngleAxisd(lift_, Vec3::UnitX()));
}

Pose DeskHand::pose() const {
  return pose_at(point_);
}

Pose DeskHand::pose_at(const Vec3& point) const {
  const Quat q = wrist();
  return {point - q * (fingertips_in_wrist + from_fingertips_), q};
}

Vec3 DeskHand::fingertips() const {
  return pose() * fingertips_in_wrist;
}

}  // namespace prosector
