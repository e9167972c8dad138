#include "client/app/commands/device_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/version.h"
#include "drivers/device/gesture.h"

namespace prosector {
namespace {

constexpr const char *fits_word = "fits", *fails_word = "DOES NOT FIT", *unseen_word = "not seen";
constexpr double fastest = 10;     // m/s: faster than any hand
constexpr double off_unit = 0.01;  // tolerance of a quaternion's norm
constexpr double late = 1.5;       // times the usual interval: longer gaps count as missing records
constexpr double max_dropped_fraction = 0.01;  // fraction of the records that arrived
constexpr double max_undetected_ratio = 1;     // maximum ratio of images without a record to those with one
constexpr double least_span = 0.5;             // flexion range of a finger that was opened and closed
constexpr std::size_t min_rate_samples = 10;   // minimum number of records for a rate

struct IntervalStatistics {
  double rate = 0, usual_ms = 0, p99_ms = 0, longest_ms = 0, jitter_ms = 0;
  std::uint64_t dropped = 0;
};

IntervalStatistics interval_statistics(const std::vector<std::int64_t>& times_ns) {
  std::vector<double> gaps_ms;
  for (std::size_t i = 1; i < times_ns.size(); ++i)
    gaps_ms.push_back(1e-6 * static_cast<double>(times_ns[i] - times_ns[i - 1]));
  IntervalStatistics out;
  if (gaps_ms.empty()) return out;
  std::ranges::sort(gaps_ms);
  const auto at = [&](double share) {
    return gaps_ms[static_cast<std::size_t>(share * static_cast<double>(gaps_ms.size() - 1))];
  };
  out.usual_ms = at(0.5);
  out.p99_ms = at(0.99);
  out.longest_ms = gaps_ms.back();
  out.jitter_ms = (at(0.84) - at(0.16)) / 2;
  const double span_s = 1e-9 * static_cast<double>(times_ns.back() - times_ns.front());
  out.rate = span_s > 0 ? static_cast<double>(gaps_ms.size()) / span_s : 0;
  // Records that arrive in one packet have gaps near 0: then the mean interval is more reliable than the
  // median.
  const double expected = std::max(out.usual_ms, out.rate > 0 ? 1e3 / out.rate / 2 : 0.0);
  for (const double gap : gaps_ms)
    if (expected > 0 && gap > late * expected + 5)
      out.dropped += static_cast<std::uint64_t>(std::lround(gap / expected)) - 1;
  return out;
}

bool has_raw_quaternion(const DeviceSample& s) {
  return std::any_of(s.raw_pose.begin() + 3, s.raw_pose.end(), [](float x) { return x != 0; }) &&
         std::all_of(s.raw_pose.begin() + 3, s.raw_pose.end(), [](float x) { return std::abs(x) <= 1.5f; });
}

}  // namespace

void DeviceReport::take(const std::vector<DeviceSample>& samples, const DeviceStatus& status,
                        double seconds) {
  const bool first = states_.empty();
  if (first || status.health != status_.health)
    states_.push_back(fmt::format("{:7.2f} s  {}{}{}", seconds, health_name(status.health),
                                  status.message.empty() ? "" : ": ", status.message));
  status_ = status;
  seconds_ = seconds;
  for (const DeviceSample& sample : samples) take(sample);
}

void DeviceReport::take(const DeviceSample& s) {
  Station& station = stations_[s.station];
  const bool falls = !station.times_ns.empty() && s.time_ns < station.times_ns.back();
  const double dt =
      station.times_ns.empty() ? 0 : 1e-9 * static_cast<double>(s.time_ns - station.times_ns.back());
  if (falls) ++station.falling_stamps;
  if (!falls) station.times_ns.push_back(s.time_ns);
  if (s.error != ' ') ++station.errors;
  station.buttons |= s.buttons;
  if (s.gesture != Gesture::none) ++station.gestures[s.gesture];
  if (s.has_pose) {
    const Vec3& p = s.pose.p;
    if (station.poses == 0) station.low = station.high = station.last = p;
    const double step = (p - station.last).norm();
    // Records that were read together give no valid speed.
    if (dt > 1e-3 && step > fastest * dt) ++station.jumps;
    station.longest_step = std::max(station.longest_step, step);
    station.low = station.low.cwiseMin(p);
    station.high = station.high.cwiseMax(p);
    station.last = p;
    ++station.poses;
    const Eigen::Vector4f q(s.raw_pose[3], s.raw_pose[4], s.raw_pose[5], s.raw_pose[6]);
    if (has_raw_quaternion(s) && std::abs(static_cast<double>(q.norm()) - 1) > off_unit)
      ++station.odd_quaternions;
  }
  if (s.has_flexion) {
    for (std::size_t f = 0; f < fingers; ++f) {
      const bool begins = station.bent == 0;
      station.least[f] = begins ? s.flexion[f] : std::min(station.least[f], s.flexion[f]);
      station.most[f] = begins ? s.flexion[f] : std::max(station.most[f], s.flexion[f]);
      station.least_raw[f] = begins ? s.raw_flexion[f] : std::min(station.least_raw[f], s.raw_flexion[f]);
      station.most_raw[f] = begins ? s.raw_flexion[f] : std::max(station.most_raw[f], s.raw_flexion[f]);
    }
    ++station.bent;
  }
}

std::vector<DeviceReport::Line> DeviceReport::lines() const {
  std::vector<Line> out;
  const auto say = [&](bool good, std::string what) {
    out.push_back({good ? fits_word : fails_word, std::move(what)});
  };
  say(status_.records > 0, fmt::format("{} valid records in {:.1f} s", status_.records, seconds_));
  say(status_.resyncs == 0, fmt::format("invalid data skipped {} times, {} bytes in total", status_.resyncs,
                                        status_.skipped_bytes));
  say(status_.reopens == 0, fmt::format("reopened {} times", status_.reopens));
  say(status_.health == DeviceHealth::streaming,
      fmt::format("state at the end: {}", health_name(status_.health)));
  for (const auto& [number, station] : stations_) judge(number, station, out);
  return out;
}

void DeviceReport::judge(std::uint32_t number, const Station& station, std::vector<Line>& out) const {
  const auto say = [&](const char* verdict, const std::string& what) {
    out.push_back({verdict, fmt::format("station {}: {}", number + 1, what)});
  };
  const auto judged = [](bool good) { return good ? fits_word : fails_word; };
  const IntervalStatistics rhythm = interval_statistics(station.times_ns);
  const std::size_t count = station.times_ns.size();
  say(count < min_rate_samples ? unseen_word : fits_word,
      fmt::format("{:.1f} records per second; interval between records {:.2f} ms (median), {:.2f} ms (p99), "
                  "{:.1f} ms (max); timestamp jitter {:.2f} ms",
                  rhythm.rate, rhythm.usual_ms, rhythm.p99_ms, rhythm.longest_ms, rhythm.jitter_ms));
  const Line missed = missing(rhythm.dropped, count);
  say(missed.verdict, missed.what);
  say(judged(station.falling_stamps == 0), fmt::format("{} decreasing timestamps", station.falling_stamps));
  say(judged(station.errors == 0),
      fmt::format("{} records with an error flag from the device", station.errors));
  if (station.poses > 0) {
    const Vec3 size = 1e3 * (station.high - station.low);
    say(size.norm() > 1 ? fits_word : unseen_word,
        fmt::format("moved within a box of {:.0f} x {:.0f} x {:.0f} mm (x, y, z of the room)", size.x(),
                    size.y(), size.z()));
    say(judged(station.jumps == 0),
        fmt::format("{} jumps of the position faster than {} m/s; longest step between two records {:.1f} mm",
                    station.jumps, fastest, 1e3 * station.longest_step));
    say(judged(station.odd_quaternions == 0),
        fmt::format("{} quaternions deviate from unit length by more than {} %", station.odd_quaternions,
                    100 * off_unit));
  }
  for (std::size_t f = 0; f < fingers && station.bent > 0; ++f)
    say(station.most[f] - station.least[f] >= least_span ? fits_word : unseen_word,
        fmt::format("finger {} (1 is the thumb): measured flexion {:.2f} to {:.2f}, sensor counts {} to {}",
                    f + 1, station.least[f], station.most[f], station.least_raw[f], station.most_raw[f]));
  std::string seen;
  for (const auto& [gesture, times] : station.gestures) seen += fmt::format(" {}", gesture_name(gesture));
  if (station.bent > 0) say(seen.empty() ? unseen_word : fits_word, "gestures:" + seen);
  say(station.buttons == 0 ? unseen_word : fits_word, fmt::format("buttons: {:#x}", station.buttons));
}

DeviceReport::Line DeviceReport::missing(std::uint64_t dropped, std::size_t count) const {
  const double share = static_cast<double>(dropped) / static_cast<double>(std::max<std::size_t>(count, 1));
  if (!is_camera_)
    return {share <= max_dropped_fraction ? fits_word : fails_word,
            fmt::format("about {} records are missing", dropped)};
  return {
      share <= max_dropped_fraction   ? fits_word
      : share <= max_undetected_ratio ? unseen_word
                                      : fails_word,
      fmt::format("in about {} images nothing was detected, or there was no time to process them", dropped)};
}

bool DeviceReport::fits() const {
  return std::ranges::none_of(lines(), [](const Line& line) { return line.verdict == fails_word; });
}

std::string DeviceReport::text() const {
  std::string out = fmt::format("{}\ndevice {}, {:.1f} s\n\n", version_line("prosector-client selftest"),
                                address_, seconds_);
  for (const Line& line : lines()) out += fmt::format("{:<13} {}\n", line.verdict, line.what);
  out += "\nIts states:\n";
  for (const std::string& state : states_) out += state + "\n";
  return out;
}

}  // namespace prosector
