#include "tests/haptics/haptic_case.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <deque>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

namespace prosector {
namespace {

constexpr double server_step = 1. / 60, send_step = 1. / 120;  // s
constexpr double approach = 0.01;                              // m: where the hand begins, outside
constexpr double approach_time = 0.3;                          // s
constexpr double swing = 0.3;                                  // of the depth
constexpr double felt_at_all = 0.05;                           // N
constexpr double plane_distance = 0.05;                        // m: how far off the tissue is told of

/// Messages that are under way. An overtaken one is dropped, as best effort does.
template <class T>
class Line {
 public:
  Line(const LineQuality& quality, std::mt19937_64& random) : quality_(quality), random_(random) {}
  void send(const T& message, double time) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double lost = uniform(random_), late = uniform(random_);
    if (lost < quality_.loss) return;
    under_way_.push_back({time + quality_.round_trip / 2 + late * quality_.jitter, sent_++, message});
  }
  /// Returns the newest message that arrived until `time`.
  std::optional<T> receive(double time) {
    std::optional<T> newest;
    for (auto it = under_way_.begin(); it != under_way_.end();) {
      if (it->arrives > time) {
        ++it;
        continue;
      }
      if (it->number >= next_) {
        next_ = it->number + 1;
        newest = it->message;
      }
      it = under_way_.erase(it);
    }
    return newest;
  }

 private:
  struct Sent {
    double arrives;
    std::uint64_t number;
    T message;
  };
  LineQuality quality_;
  std::mt19937_64& random_;
  std::deque<Sent> under_way_;
  std::uint64_t sent_ = 0, next_ = 0;
};

/// Where the hand wants to be, m, and how fast, m/s. The tissue fills x < 0.
struct Wish {
  double place, speed;
};
Wish wish(const HapticCase& test, double t) {
  const double way = approach + test.depth;
  if (test.free) {
    const double omega = 2 * std::numbers::pi * 1;
    return {0.05 + 0.03 * std::sin(omega * t), 0.03 * omega * std::cos(omega * t)};
  }
  if (t < approach_time) return {approach - way * t / approach_time, -way / approach_time};
  if (test.frequency == 0) return {-test.depth, 0};
  const double omega = 2 * std::numbers::pi * test.frequency, s = t - approach_time;
  return {-test.depth * (1 - swing * std::sin(omega * s)), test.depth * swing * omega * std::cos(omega * s)};
}

using Planes = std::vector<ContactPlane>;

Planes tell(const HapticScheme& scheme, const HapticCase& test, double place, double speed) {
  const double depth = -place;
  if (test.free || depth < (scheme.before_contact ? -plane_distance : 0)) return {};
  ContactPlane plane;
  plane.id = 1;
  plane.normal = Vec3::UnitX();
  plane.stiffness =
      scheme.reported_stiffness < 0 ? -scheme.reported_stiffness * test.stiffness : scheme.reported_stiffness;
  plane.tangential = plane.stiffness;
  plane.damping = test.tissue_damping;
  plane.radius = 0.01;
  // Before it is met, it is the surface that is told of.
  const double pressed = depth > 0 ? test.stiffness * depth - test.tissue_damping * speed : 0;
  plane.point = Vec3(depth > 0 ? place : 0, 0, 0);
  plane.force = std::max(0., pressed) * Vec3::UnitX();
  return {plane};
}

}  // namespace

HapticResult run(const HapticScheme& scheme, const HapticCase& test) {
  std::mt19937_64 random(test.seed);
  Line<Vec3> up(test.line, random);
  Line<Planes> down(test.line, random);
  ArmModel arm({}, test.hand, Vec3(wish(test, 0).place, 0, 0));
  HapticLoop loop(omni_limits(), scheme.safeguards);
  HapticResult result;

  std::optional<double> server_place;
  double server_speed = 0, next_tick = 0.004, next_send = 0.002;  // s: clocks that know nothing of each other
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  double sum_force = 0, sum_depth = 0, met = -1, drag = 0, way = 0;
  std::complex<double> force_swing = 0, place_swing = 0;
  int counted = 0;
  // The guard's ramp ends before the hand begins, as a user's does who takes an arm up.
  const double begin = -0.5;
  const auto steps = static_cast<int>(std::lround((test.seconds - begin) / dt));
  for (int k = 0; k < steps; ++k) {
    const double t = begin + k * dt;
    if (const auto planes = down.receive(t)) loop.take(*planes, t - begin);
    ArmReading reading;
    reading.valid = true;
    reading.stylus.p = arm.measured();
    arm.set_force(loop.cycle(reading, t - begin + dt));
    if (t - begin >= next_send) {
      up.send(reading.stylus.p, t);
      next_send += send_step;
    }
    if (t - begin >= next_tick) {
      next_tick += server_step;
      const auto heard = up.receive(t);
      if (heard) {
        server_speed = server_place ? (heard->x() - *server_place) / server_step : 0;
        server_place = heard->x();
      }
      if (server_place) down.send(tell(scheme, test, *server_place, server_speed), t);
    }
    const Wish wanted = wish(test, std::max(0., t));
    const double before = arm.position().x();
    arm.advance(dt, Vec3(wanted.place, 0, 0), Vec3(t > 0 ? wanted.speed : 0, 0, 0));
    const double x = arm.position().x(), f = arm.force().x();
    if (!std::isfinite(x)) {
      result.finite = false;
      break;
    }
    result.least_energy = std::min(result.least_energy, arm.energy());
    if (met < 0 && x < 0 && !test.free) met = t;
    if (met >= 0 && result.onset == 0 && f > felt_at_all) result.onset = t - met;
    result.peak = std::max(result.peak, f);
    drag -= f * (x - before);
    way += std::abs(x - before);
    if (t < test.seconds - 1) continue;
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
    sum_force += f;
    sum_depth -= x;
    const std::complex<double> turn =
        std::polar(1., -2 * std::numbers::pi * test.frequency * (t - approach_time));
    force_swing += f * turn;
    place_swing -= x * turn;
    ++counted;
  }
  result.ripple = highest - lowest;
  if (counted > 0 && sum_depth > 0) result.felt = sum_force / sum_depth / test.stiffness;
  if (test.frequency > 0 && std::abs(place_swing) > 0)
    result.felt_swinging = std::abs(force_swing / place_swing) / test.stiffness;
  if (counted > 0 && sum_force > 0) result.peak /= sum_force / counted;
  if (way > 0) result.drag = drag / way;
  return result;
}

}  // namespace prosector
