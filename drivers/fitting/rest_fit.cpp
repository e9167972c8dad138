#include "drivers/fitting/rest_fit.h"

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double minute = 60;

/// A line fitted to values over time, and its residual.
struct Line {
  Vec3 slope = Vec3::Zero();
  Vec3 variance = Vec3::Zero();  // residual variance, each axis
  double spread = 0;             // Σ (t − mean t)²
};

Line line_through(std::span<const double> times, std::span<const Vec3> values) {
  const auto n = static_cast<double>(times.size());
  double mean_t = 0;
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < times.size(); ++i) {
    mean_t += times[i] / n;
    mean += values[i] / n;
  }
  Line out;
  for (std::size_t i = 0; i < times.size(); ++i) {
    out.spread += (times[i] - mean_t) * (times[i] - mean_t);
    out.slope += (times[i] - mean_t) * (values[i] - mean);
  }
  out.slope /= out.spread;
  for (std::size_t i = 0; i < times.size(); ++i)
    out.variance += (values[i] - mean - (times[i] - mean_t) * out.slope).cwiseAbs2() / (n - 2);
  return out;
}

}  // namespace

RestFit fit_rest(std::span<const TimedPose> readings) {
  RestFit fit;
  fit.readings = readings.size();
  if (readings.size() >= 2)
    fit.seconds = 1e-9 * static_cast<double>(readings.back().time_ns - readings.front().time_ns);
  if (readings.size() < least_rest_readings || fit.seconds < least_rest_seconds)
    throw InputError(
        fmt::format("the receiver sent {} readings in {:.1f} s: at least {} in {:.0f} s are needed",
                    readings.size(), fit.seconds, least_rest_readings, least_rest_seconds));
  fit.rate = static_cast<double>(readings.size() - 1) / fit.seconds;
  const Quat first = readings.front().pose.q;
  std::vector<double> times;
  std::vector<Vec3> places, turns;
  for (const TimedPose& r : readings) {
    times.push_back(1e-9 * static_cast<double>(r.time_ns - readings.front().time_ns));
    places.push_back(r.pose.p);
    const Eigen::AngleAxisd turn(r.pose.q * first.conjugate());
    const double angle = std::remainder(turn.angle(), 2 * M_PI);
    turns.push_back(angle * turn.axis());
  }
  const Line p = line_through(times, places), q = line_through(times, turns);
  fit.axis_noise = p.variance.cwiseSqrt();
  fit.noise = std::sqrt(p.variance.sum());
  fit.turn_noise = std::sqrt(q.variance.sum());
  fit.drift = minute * p.slope.norm();
  fit.turn_drift = minute * q.slope.norm();
  fit.drift_error = minute * std::sqrt(p.variance.sum() / p.spread);
  if (fit.noise > max_rest_motion)
    throw InputError(fmt::format(
        "the receiver moved by {:.0f} mm RMS during the measurement: lay it down and don't touch it",
        1e3 * fit.noise));
  return fit;
}

}  // namespace prosector
