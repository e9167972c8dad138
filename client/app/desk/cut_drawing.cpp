#include "client/app/desk/cut_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double spacing = 0.003;       // m between points on the path
constexpr double shortest_way = 0.006;  // m: minimum length of a path with a defined direction
constexpr double window_normal =
    0.012;  // m, before and behind the blade, over which the surface normal is averaged
constexpr double window_behind = 0.004,
                 window_ahead = 0.008;  // m, over which the direction of the cut is taken
constexpr double steady = 0.75;         // low-pass filter: weight of the previous point's normal
constexpr double over_surface = 0.02;  // m above the surface: start of the rays that project the path onto it
constexpr double rim_extension =
    0.008;  // m by which the path is extended where the pointer crosses an organ's rim
constexpr double max_time_off_organ = 0.15;  // s that the pointer may be off the organ before the path ends
constexpr double tip_trail_angle = 0.3, min_tilt = -0.2,
                 max_tilt = 0.9;  // rad, angle of the tip behind the surface normal
constexpr double usable_blade_fraction =
    0.6;  // fraction of its length that may be in tissue; the rest allows for its inclination
constexpr double move_speed = 0.5, down_speed = 0.1, draw_speed = 0.12, up_speed = 0.2;  // m/s
constexpr double turn_speed = 2.5;                                                       // rad/s
constexpr double turned = 0.05, max_misalignment = 0.4;                                  // rad
constexpr double near_enough = 0.004, felt_within = 0.02;                                // m
constexpr double felt_turned = 0.25;                                                     // rad
constexpr double over_turn = 0.12;  // m, height of the tip over the surface during large rotations
constexpr double longest_wait = 5;  // s, timeout of waiting for the simulated hand
constexpr double arm = 0.1;         // m: lever arm that converts angles to distances
constexpr double max_lag = 0.06, min_speed_factor = 0.05;  // m, distance of the simulated hand at which the
                                                           // speed is least; minimum speed factor
constexpr double fine_depth = 0.02, fine_notch = 0.001, coarse_notch = 0.005, deepest = 0.2;  // m
constexpr double preview_behind = 0.015, preview_ahead = 0.025;                               // m

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

/// Returns the speed factor, 0 … 1. It falls as the simulated blade lags behind, because tissue resists it
/// and simulation may run slower than real time. `tip`: target position of the tip, m, world frame.
double speed_factor(const CutGuide& guide, const Pose& wrist, const Vec3& tip) {
  if (!guide.physical) return 1;
  const double rotated_by = guide.physical->q.angularDistance(wrist.q);
  const double behind = std::max((*guide.physical * guide.blade.tip - tip).norm(), rotated_by * arm);
  return std::clamp((max_lag - behind) / (max_lag - felt_within), min_speed_factor, 1.0);
}

}  // namespace

Quat blade_rotation(const BladeFrame& blade, const Vec3& normal, const Vec3& way) {
  const double down = std::atan2(
      way.y(), normal.y());  // angle of gravity's direction from the inward normal, in the blade's plane
  const double lean = std::clamp(tip_trail_angle + down, min_tilt, max_tilt);
  const Vec3 along = -std::cos(lean) * normal - std::sin(lean) * way;
  const Vec3 ahead = std::cos(lean) * way - std::sin(lean) * normal;
  Mat3 in_hand, in_room;
  in_hand << blade.along, blade.ahead, blade.along.cross(blade.ahead);
  in_room << along, ahead, along.cross(ahead);
  return Quat(in_room * in_hand.transpose()).normalized();
}

Quat rotated_towards(const Quat& from, const Quat& to, double most) {
  const double angle = from.angularDistance(to);
  return angle > most ? from.slerp(most / angle, to).normalized() : to;
}

void CutDrawing::press() {
  pressed_ = true;
  again_ = phase_ != Phase::rests;
  if (!again_) go_to(Phase::waits);
}

void CutDrawing::release() {
  if (open_ && away_ > 0) extend_over_rims(true);
  pressed_ = open_ = again_ = false;
}

void CutDrawing::stop() {
  release();
  go_to(Phase::rests);
  way_.clear();
  gone_.clear();
}

void CutDrawing::withdraw_blade() {
  release();
  if (phase_ != Phase::lifts) phase_ == Phase::cuts ? go_to(Phase::lifts) : stop();
}

void CutDrawing::deepen(double notches) {
  if (!std::isfinite(notches)) return;
  const bool coarse = depth_ > fine_depth || (depth_ == fine_depth && notches > 0);
  depth_ = std::clamp(depth_ + notches * (coarse ? coarse_notch : fine_notch), least_cut_depth, deepest);
}

void CutDrawing::go_to(Phase phase) {
  phase_ = phase;
  seconds_ = 0;
  if (phase != Phase::waits) return;
  way_.clear();
  gone_.clear();
  done_ = away_ = 0;
  open_ = true;
  came_on_ = false;
}

std::optional<Pose> CutDrawing::advance(const CutGuide& guide, const Pose& wrist, double seconds) {
  seconds_ += seconds;
  if (phase_ == Phase::rests && std::exchange(again_, false)) go_to(Phase::waits);
  follow_pointer(guide, seconds);
  seconds = std::min(seconds, longest_step);
  switch (phase_) {
    case Phase::rests:
      return std::nullopt;
    case Phase::waits:
      blade_ = guide.blade;
      if (length() >= shortest_way) {
        if (came_on_) extend_over_rims(false);
        go_to(Phase::turns);
      } else if (!open_)
        go_to(Phase::rests);
      return std::nullopt;
    case Phase::turns:
      return approach_path(guide, wrist, seconds);
    case Phase::cuts:
      return draw(guide, wrist, seconds);
    case Phase::lifts:
      return lift(wrist, seconds);
  }
  return std::nullopt;
}

/// Stores the pointer's position and direction on tissue, and extends the path while it is open.
void CutDrawing::follow_pointer(const CutGuide& guide, double seconds) {
  const bool on_outside = guide.tissue && !guide.tissue->inner;
  if (on_outside && last_ && (guide.tissue->at - *last_).norm() >= spacing) {
    const Vec3 way = (guide.tissue->at - *last_).normalized();
    heading_ = (heading_ + way).norm() > 0.1 ? (heading_ + way).normalized() : way;
  }
  if (on_outside && (!last_ || (guide.tissue->at - *last_).norm() >= spacing)) last_ = guide.tissue->at;
  if (!open_ || phase_ == Phase::rests) return;
  if (way_.empty() && !guide.tissue) came_on_ = true;
  const bool on_organ = guide.tissue && (way_.empty() || guide.tissue->body == organ_);
  away_ = on_organ || way_.empty() ? 0 : away_ + seconds;
  if (away_ > max_time_off_organ && std::exchange(open_, false)) extend_over_rims(true);
  if (on_organ && on_outside) lead(*guide.tissue, guide.find);
}

void CutDrawing::trace(const Picked& tissue, const FindSurface& find) {
  const bool leads_on = open_ && phase_ != Phase::rests && !tissue.inner;
  if (leads_on && (way_.empty() || tissue.body == organ_)) lead(tissue, find);
}

/// Extends the path to the pointer along the surface in between.
void CutDrawing::lead(const Picked& to, const FindSurface& find) {
  if (way_.empty()) {
    organ_ = to.body;
    return add(to.at, to.normal);
  }
  const Place from = way_.back();
  const double far = (to.at - from.at).norm();
  if (far < spacing) return;
  const int steps = std::max(1, static_cast<int>(std::lround(far / spacing)));
  for (int k = 1; k < steps; ++k) {
    const double share = static_cast<double>(k) / steps;
    const Vec3 normal = ((1 - share) * from.normal + share * to.normal).normalized();
    const Vec3 at = (1 - share) * from.at + share * to.at;
    const auto under = find({at + over_surface * normal, -normal}, organ_);
    if (under && !under->inner && under->distance < 2 * over_surface) add(under->at, under->normal);
  }
  add(to.at, to.normal);
}

void CutDrawing::add(const Vec3& at, const Vec3& normal) {
  if (way_.empty()) {
    way_.push_back({at, normal});
    gone_.push_back(0);
    return;
  }
  const double step = (at - way_.back().at).norm();
  if (!(step > spacing / 4)) return;
  way_.push_back({at, (steady * way_.back().normal + (1 - steady) * normal).normalized()});
  gone_.push_back(gone_.back() + step);
}

/// Extends the path at its beginning or end beyond the rim that the pointer crossed. Otherwise tissue between
/// the rim and the nearest frame's point would stay uncut.
void CutDrawing::extend_over_rims(bool at_its_end) {
  if (length() < shortest_way) return;
  const double from = at_its_end ? length() : 0;
  const Vec3 at = place(from).at, inward = place(at_its_end ? from - shortest_way : shortest_way).at;
  const Place beyond{at + rim_extension * (at - inward).normalized(), place(from).normal};
  if (at_its_end) return add(beyond.at, beyond.normal);
  way_.insert(way_.begin(), beyond);
  for (double& gone : gone_) gone += rim_extension;
  gone_.insert(gone_.begin(), 0);
}

CutDrawing::Place CutDrawing::place(double gone) const {
  const auto next = std::upper_bound(gone_.begin(), gone_.end(), std::clamp(gone, 0.0, length()));
  if (next == gone_.end()) return way_.back();
  const auto k = static_cast<std::size_t>(next - gone_.begin());
  const double share = (std::max(gone, 0.0) - gone_[k - 1]) / (gone_[k] - gone_[k - 1]);
  const Place &a = way_[k - 1], &b = way_[k];
  return {(1 - share) * a.at + share * b.at, ((1 - share) * a.normal + share * b.normal).normalized()};
}

/// Returns the wrist rotation with the blade in the plane of the path and the normal, its edge ahead.
Quat CutDrawing::target_rotation() const {
  Vec3 normal = Vec3::Zero();  // averaged over a longer stretch: rotations in tissue push it aside
  for (const double beside : {-window_normal, 0.0, window_normal}) normal += place(done_ + beside).normal;
  normal.normalize();
  Vec3 way = place(done_ + window_ahead).at - place(done_ - window_behind).at;
  way = (way - way.dot(normal) * normal).normalized();
  if (!way.allFinite()) way = normal.unitOrthogonal();
  return blade_rotation(blade_, normal, way);
}

/// Returns the wrist pose with this rotation that puts the blade's tip at its target.
Pose CutDrawing::wrist_at(const Quat& turn) const {
  const Place here = place(done_);
  return {here.at + height_ * here.normal - turn * blade_.tip, turn};
}

/// Moves the blade over the path's beginning and rotates it. For large rotations it stays high, because its
/// edge would nick tissue near its tip.
Pose CutDrawing::approach_path(const CutGuide& guide, const Pose& wrist, double seconds) {
  seconds *= speed_factor(guide, wrist, wrist * blade_.tip);
  const Quat to = target_rotation();
  height_ = wrist.q.angularDistance(to) > max_misalignment ? over_turn : over_cut;
  const Quat turn = rotated_towards(wrist.q, to, turn_speed * seconds);
  const Vec3 tip = wrist * blade_.tip, goal = wrist_at(to) * blade_.tip;
  const Vec3 step = goal - tip;
  const double most = move_speed * seconds;
  const Vec3 next = step.norm() > most ? Vec3(tip + most / step.norm() * step) : goal;
  const Pose out{next - turn * blade_.tip, turn};
  const bool in_place = turn.angularDistance(to) < turned && (next - goal).norm() < near_enough;
  const bool felt = guide.physical && guide.physical->q.angularDistance(out.q) < felt_turned &&
                    (guide.physical->p - out.p).norm() < felt_within;
  if (in_place && (felt || seconds_ > longest_wait)) go_to(Phase::cuts);
  return out;
}

Pose CutDrawing::draw(const CutGuide& guide, const Pose& wrist, double seconds) {
  seconds *= speed_factor(guide, wrist, wrist * blade_.tip);
  const double down = -std::min(depth_, usable_blade_fraction * blade_.length);
  height_ = towards(height_, down, down_speed * seconds);
  const Quat to = target_rotation();
  const Quat turn = rotated_towards(wrist.q, to, turn_speed * seconds);
  const bool is_in = height_ < down + near_enough && turn.angularDistance(to) < max_misalignment;
  if (is_in) done_ = std::min(done_ + draw_speed * seconds, length());
  if (is_in && !open_ && done_ >= length()) go_to(Phase::lifts);
  return wrist_at(turn);
}

Pose CutDrawing::lift(const Pose& wrist, double seconds) {
  height_ = towards(height_, over_cut, up_speed * seconds);
  const Pose out = wrist_at(wrist.q);
  if (height_ >= over_cut) {
    go_to(Phase::rests);
    way_.clear();
    gone_.clear();
  }
  return out;
}

std::vector<Vec3> CutDrawing::line(const CutGuide& guide) const {
  std::vector<Vec3> out;
  if (!way_.empty() && length() > 0) {
    constexpr double lift_off = 0.001;  // m
    const auto add_place = [&](const Place& at) { out.push_back(at.at + lift_off * at.normal); };
    add_place(place(done_));
    for (std::size_t k = 0; k < way_.size(); ++k)
      if (gone_[k] > done_) add_place(way_[k]);
    return out;
  }
  if (!guide.tissue || guide.tissue->inner) return out;
  const Vec3& normal = guide.tissue->normal;
  const Vec3 heading = heading_.isZero() ? guide.right : heading_;
  const Vec3 along = (heading - heading.dot(normal) * normal).normalized();
  if (along.allFinite()) out = draped_line(guide.find, *guide.tissue, along, preview_behind, preview_ahead);
  return out;
}

}  // namespace prosector
