#pragma once
// Options and timing shared by simulated trackers behind a program: the script's time, and the times of
// records.

#include <cmath>
#include <optional>

#include "drivers/recordings/motion_script.h"
#include "twins/base/twin.h"

namespace prosector {

struct TrackerTwinOptions {
  MotionScript script;
  Pose room_device;  // pose of the device frame in the room frame
  TwinTiming timing;
  std::size_t stations = 1;          // number of reported stations
  double rate = 100;                 // Hz
  double bad_checksum_fraction = 0;  // fraction of messages with a wrong checksum
  std::uint64_t seed = 1;
  std::optional<FaultSpan> wrong_version;  // period in which the twin announces a wrong protocol version, s
};

/// Clock of a simulated tracker: schedules its records and evaluates the motion script at their times.
class TrackerClock {
 public:
  TrackerClock(const TrackerTwinOptions& options, std::int64_t now_ns)
      : options_(options),
        script_(options.timing, now_ns),
        start_ns_(now_ns),
        next_ns_(now_ns),
        period_ns_(std::llround(1e9 / options.rate)) {}

  bool sends_wrong_version(std::int64_t now_ns) const {
    return options_.wrong_version &&
           options_.wrong_version->contains(1e-9 * static_cast<double>(now_ns - start_ns_));
  }
  /// Returns whether a record is due at `now_ns`. If so, schedules the next record one period later, and
  /// starts the motion script if it waits for the first record.
  bool due(std::int64_t now_ns) {
    if (now_ns < next_ns_) return false;
    next_ns_ += (1 + (now_ns - next_ns_) / period_ns_) * period_ns_;
    script_.streaming(now_ns);
    return true;
  }
  std::int64_t next_ns() const { return next_ns_; }
  void go_on(std::int64_t now_ns) { script_.go_on(now_ns); }

  /// Returns the pose (m, device frame) that the script prescribes at `now_ns` for a station, a tracked
  /// object with index from 0.
  Pose pose(std::size_t station, std::int64_t now_ns) const {
    return options_.room_device.inverse() *
           options_.script.pose(station, script_.seconds(now_ns), options_.timing.loop);
  }
  std::array<double, fingers> flexion(std::size_t station, std::int64_t now_ns) const {
    return options_.script.flexion(station, script_.seconds(now_ns), options_.timing.loop);
  }

 private:
  TrackerTwinOptions options_;
  ScriptClock script_;
  std::int64_t start_ns_, next_ns_, period_ns_;
};

/// Returns a record's values in the order of the log: position x y z (m or mm, as sent), then quaternion w x
/// y z.
inline std::vector<float> record_values(const Vec3& place, const Quat& turn) {
  return {static_cast<float>(place.x()), static_cast<float>(place.y()), static_cast<float>(place.z()),
          static_cast<float>(turn.w()),  static_cast<float>(turn.x()),  static_cast<float>(turn.y()),
          static_cast<float>(turn.z())};
}

}  // namespace prosector
