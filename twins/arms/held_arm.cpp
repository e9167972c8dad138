#include "twins/arms/held_arm.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double approach_seconds = 0.8;  // duration of the motion from rest to the script's first position
constexpr double longest_gap = 0.05;      // s: maximum simulated time per call
constexpr double time_step = 1e-3;        // s, for differentiating the script

Vec3 beginning(const HeldArmOptions& options) {
  return options.room_arm.inverse() * options.script.pose(0, 0, options.timing.loop).p;
}

}  // namespace

HeldArm::HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, const Vec3& rest, std::int64_t now_ns)
    : options_(std::move(options)),
      clock_(options_.timing, now_ns),
      now_ns_(now_ns),
      rest_(rest),
      model_(mechanics, options_.hand, rest),
      wrist_({}, options_.hand, intended_turn()),
      intended_(rest) {}

HeldArm::HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, std::int64_t now_ns)
    : HeldArm(options, mechanics, beginning(options), now_ns) {}

void HeldArm::take(std::int64_t time_ns) {
  if (taken_) return;
  taken_ = true;
  taken_ns_ = time_ns;
}

void HeldArm::put_down() {
  taken_ = false;
  rest_ = model_.position();
  set_force(Vec3::Zero());
}

void HeldArm::set_force(const Vec3& force, const Vec3& torque) {
  model_.set_force(taken_ ? force : Vec3(Vec3::Zero()));
  wrist_.set_torque(taken_ ? torque : Vec3(Vec3::Zero()));
}

void HeldArm::advance(std::int64_t now_ns) {
  const double dt = std::min(longest_gap, 1e-9 * static_cast<double>(now_ns - now_ns_));
  now_ns_ = now_ns;
  if (!taken_ || dt <= 0) return;
  if (1e-9 * static_cast<double>(now_ns - taken_ns_) >= approach_seconds) clock_.streaming(now_ns);
  const Wish wanted = wish();
  intended_ = wanted.place;
  model_.advance(dt, wanted.place, wanted.velocity);
  wrist_.advance(dt, intended_turn());
}

/// Returns the hand's target orientation of the stylus, arm frame.
Quat HeldArm::intended_turn() const {
  const Quat room = options_.script.pose(0, clock_.seconds(now_ns_), options_.timing.loop).q;
  return options_.room_arm.q.conjugate() * room;
}

/// Returns the script's position of the tip, m, arm frame.
Vec3 HeldArm::scripted(double seconds) const {
  return options_.room_arm.inverse() * options_.script.pose(0, seconds, options_.timing.loop).p;
}

/// Returns the hand's target position and velocity of the tip, arm frame.
HeldArm::Wish HeldArm::wish() const {
  const double t = clock_.seconds(now_ns_);
  const Vec3 place = scripted(t),
             velocity = (scripted(t + time_step) - scripted(t - time_step)) / (2 * time_step);
  const double since = 1e-9 * static_cast<double>(now_ns_ - taken_ns_);
  if (since >= approach_seconds) return {place, velocity};
  const double u = std::clamp(since / approach_seconds, 0., 1.), s = u * u * (3 - 2 * u);
  const Vec3 way = place - rest_;
  return {rest_ + s * way, 6 * u * (1 - u) / approach_seconds * way};
}

}  // namespace prosector
