#include "drivers/fitting/timed_guides.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace prosector {
namespace {

double seconds_of(const std::vector<TimedPose>& readings) {
  return readings.empty() ? 0
                          : 1e-9 * static_cast<double>(readings.back().time_ns - readings.front().time_ns);
}

/// Returns the distances from the mean position of the readings between two times.
std::vector<TimedValue> distances(const std::vector<TimedPose>& readings, std::int64_t from_ns,
                                  std::int64_t to_ns) {
  std::vector<TimedPose> within;
  for (const TimedPose& r : readings)
    if (r.time_ns >= from_ns && r.time_ns <= to_ns) within.push_back(r);
  Vec3 mean = Vec3::Zero();
  for (const TimedPose& r : within) mean += r.pose.p / static_cast<double>(within.size());
  std::vector<TimedValue> out;
  for (const TimedPose& r : within) out.push_back({r.time_ns, (r.pose.p - mean).norm()});
  return out;
}

}  // namespace

void RestGuide::take(const DeviceSample& sample) {
  if (sample.station == station_ && sample.has_trusted_pose() && passed() < seconds_)
    readings_.push_back({sample.time_ns, sample.pose});
}

double RestGuide::passed() const {
  return seconds_of(readings_);
}

GuideStep RestGuide::step() const {
  GuideStep out;
  out.done = passed() >= seconds_;
  out.index = out.done ? 1 : 0;
  out.instruction = out.done ? "" : "Lay the receiver down and don't touch it";
  out.progress = std::min(1.0, passed() / seconds_);
  return out;
}

GuideOutcome RestGuide::outcome() const {
  const RestFit f = fit();
  constexpr double degrees = 180 / std::numbers::pi;
  GuideOutcome out;
  out.words.push_back(fmt::format("noise {:.3f} mm, {:.3f}° RMS; along x, y, z {:.3f}, {:.3f}, {:.3f} mm",
                                  1e3 * f.noise, degrees * f.turn_noise, 1e3 * f.axis_noise.x(),
                                  1e3 * f.axis_noise.y(), 1e3 * f.axis_noise.z()));
  out.words.push_back(
      fmt::format("drift {:.2f} ± {:.2f} mm, {:.2f}° per minute, in {:.1f} s at {:.0f} readings per second",
                  1e3 * f.drift, 1e3 * f.drift_error, degrees * f.turn_drift, f.seconds, f.rate));
  return out;
}

void DelayGuide::take(const DeviceSample& sample) {
  if (sample.station == station_ && sample.has_trusted_pose() && seconds_of(own_) < seconds_)
    own_.push_back({sample.time_ns, sample.pose});
}

GuideStep DelayGuide::step() const {
  GuideStep out;
  out.done = seconds_of(own_) >= seconds_;
  out.index = out.done ? 1 : 0;
  out.instruction =
      out.done ? "" : "Move both devices back and forth, unevenly: sometimes fast, sometimes slow";
  out.progress = std::min(1.0, seconds_of(own_) / seconds_);
  return out;
}

void DelayGuide::back() {
  own_.clear();
  other_.clear();
}

DelayFit DelayGuide::fit() const {
  if (own_.empty() || other_.empty()) return fit_delay({}, {});
  const std::int64_t from = std::max(own_.front().time_ns, other_.front().time_ns);
  const std::int64_t to = std::min(own_.back().time_ns, other_.back().time_ns);
  return fit_delay(distances(other_, from, to), distances(own_, from, to));
}

GuideOutcome DelayGuide::outcome() const {
  const DelayFit f = fit();
  GuideOutcome out;
  out.words.push_back(
      fmt::format("the measured device is {:.2f} ± {:.2f} ms later than the reference device; "
                  "correlation {:.3f} over {:.1f} s",
                  1e3 * f.delay, 1e3 * f.error, f.correlation, f.seconds));
  return out;
}

}  // namespace prosector
