#include "client/app/cut_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector {
namespace {

constexpr double spacing = 0.003;        // m, of places along the way
constexpr double shortest_way = 0.006;   // m: a shorter one has no direction
constexpr double window_normal = 0.012;  // m, before and behind, over which the blade's normal is taken
constexpr double window_behind = 0.004, window_ahead = 0.008;  // m, over which the direction is taken
constexpr double steady = 0.75;         // share of the last place's normal in the next one's
constexpr double over_surface = 0.02;   // m, where rays that look for the way begin
constexpr double over_rim = 0.008;      // m that a way goes on where the pointer crosses an organ's rim
constexpr double patience_away = 0.15;  // s that the pointer may be off the organ
constexpr double trails = 0.3, least_lean = -0.2, most_lean = 0.9;  // rad, of the tip behind the normal
constexpr double share_of_blade = 0.6;  // of its length, that may be in tissue: it leans
constexpr double move_speed = 0.5, down_speed = 0.1, draw_speed = 0.12, up_speed = 0.2;  // m/s
constexpr double turn_speed = 2.5;                                                       // rad/s
constexpr double turned = 0.05, most_astray = 0.4;                                       // rad
constexpr double near_enough = 0.004, felt_within = 0.02;                                // m
constexpr double felt_turned = 0.25;                                                     // rad
constexpr double over_turn = 0.12;                        // m, of the tip over the surface
constexpr double longest_wait = 5;                        // s, for the physical hand
constexpr double arm = 0.1;                               // m, by which turns count as ways
constexpr double most_behind = 0.06, least_haste = 0.05;  // m, of the physical hand; of the speed
constexpr double fine_depth = 0.02, fine_notch = 0.001, coarse_notch = 0.005, deepest = 0.2;  // m
constexpr double preview_behind = 0.015, preview_ahead = 0.025;                               // m

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

/// Returns how fast to go on, as a share: slowly while the physical blade is behind, for tissue holds it back
/// and simulated time may be slow. `tip`: where it is to be.
double haste(const CutGuide& guide, const Pose& wrist, const Vec3& tip) {
  if (!guide.physical) return 1;
  const double turned_by = guide.physical->q.angularDistance(wrist.q);
  const double behind = std::max((*guide.physical * guide.blade.tip - tip).norm(), turned_by * arm);
  return std::clamp((most_behind - behind) / (most_behind - felt_within), least_haste, 1.0);
}

}  // namespace

Quat drawing_turn(const BladeFrame& blade, const Vec3& normal, const Vec3& way) {
  const double down = std::atan2(way.y(), normal.y());  // from the normal's way in, in the plane
  const double lean = std::clamp(trails + down, least_lean, most_lean);
  const Vec3 along = -std::cos(lean) * normal - std::sin(lean) * way;
  const Vec3 ahead = std::cos(lean) * way - std::sin(lean) * normal;
  Mat3 in_hand, in_room;
  in_hand << blade.along, blade.ahead, blade.along.cross(blade.ahead);
  in_room << along, ahead, along.cross(ahead);
  return Quat(in_room * in_hand.transpose()).normalized();
}

Quat turned_towards(const Quat& from, const Quat& to, double most) {
  const double angle = from.angularDistance(to);
  return angle > most ? from.slerp(most / angle, to).normalized() : to;
}

void CutDrawing::press() {
  pressed_ = true;
  again_ = phase_ != Phase::rests;
  if (!again_) go_to(Phase::waits);
}

void CutDrawing::release() {
  if (open_ && away_ > 0) lengthen_over_rims(true);
  pressed_ = open_ = again_ = false;
}

void CutDrawing::stop() {
  release();
  go_to(Phase::rests);
  way_.clear();
  gone_.clear();
}

void CutDrawing::lift_out() {
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
        if (came_on_) lengthen_over_rims(false);
        go_to(Phase::turns);
      } else if (!open_)
        go_to(Phase::rests);
      return std::nullopt;
    case Phase::turns:
      return come_over(guide, wrist, seconds);
    case Phase::cuts:
      return draw(guide, wrist, seconds);
    case Phase::lifts:
      return lift(wrist, seconds);
  }
  return std::nullopt;
}

/// Keeps where the pointer goes, and adds it to the way while that is open.
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
  if (away_ > patience_away && std::exchange(open_, false)) lengthen_over_rims(true);
  if (on_organ && on_outside) lead(*guide.tissue, guide.find);
}

void CutDrawing::trace(const Picked& tissue, const FindSurface& find) {
  const bool leads_on = open_ && phase_ != Phase::rests && !tissue.inner;
  if (leads_on && (way_.empty() || tissue.body == organ_)) lead(tissue, find);
}

/// Lays the way on to where the pointer is, over the surface between.
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

/// Lets the way begin or end beyond the rim that the pointer crossed there: pictures come before and after
/// it, and what lies between would stay tied.
void CutDrawing::lengthen_over_rims(bool at_its_end) {
  if (length() < shortest_way) return;
  const double from = at_its_end ? length() : 0;
  const Vec3 at = place(from).at, inward = place(at_its_end ? from - shortest_way : shortest_way).at;
  const Place beyond{at + over_rim * (at - inward).normalized(), place(from).normal};
  if (at_its_end) return add(beyond.at, beyond.normal);
  way_.insert(way_.begin(), beyond);
  for (double& gone : gone_) gone += over_rim;
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

/// Returns the wrist's turn with the blade in the plane of the way and the normal, its edge ahead.
Quat CutDrawing::wanted_turn() const {
  Vec3 normal = Vec3::Zero();  // of a wider stretch: a turn in tissue pushes it aside
  for (const double beside : {-window_normal, 0.0, window_normal}) normal += place(done_ + beside).normal;
  normal.normalize();
  Vec3 way = place(done_ + window_ahead).at - place(done_ - window_behind).at;
  way = (way - way.dot(normal) * normal).normalized();
  if (!way.allFinite()) way = normal.unitOrthogonal();
  return drawing_turn(blade_, normal, way);
}

/// Returns the wrist with that turn whose blade's tip is where it is to be.
Pose CutDrawing::wrist_at(const Quat& turn) const {
  const Place here = place(done_);
  return {here.at + height_ * here.normal - turn * blade_.tip, turn};
}

/// Brings the blade over the way's beginning, and turns it, high up if it has far to turn: its edge would
/// nick tissue beside its tip.
Pose CutDrawing::come_over(const CutGuide& guide, const Pose& wrist, double seconds) {
  seconds *= haste(guide, wrist, wrist * blade_.tip);
  const Quat to = wanted_turn();
  height_ = wrist.q.angularDistance(to) > most_astray ? over_turn : over_cut;
  const Quat turn = turned_towards(wrist.q, to, turn_speed * seconds);
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
  seconds *= haste(guide, wrist, wrist * blade_.tip);
  const double down = -std::min(depth_, share_of_blade * blade_.length);
  height_ = towards(height_, down, down_speed * seconds);
  const Quat to = wanted_turn();
  const Quat turn = turned_towards(wrist.q, to, turn_speed * seconds);
  const bool is_in = height_ < down + near_enough && turn.angularDistance(to) < most_astray;
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
