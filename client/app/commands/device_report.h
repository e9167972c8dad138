#pragma once
// Report that compares a device's records with its protocol, for the device's owner to read and send on.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drivers/device/device.h"

namespace prosector {

class DeviceReport {
 public:
  /// Creates a report on a device without records. `is_camera`: the records come from a camera's images. An
  /// image without detections, or one skipped for lack of time, then gives no record and is not an error.
  DeviceReport(std::string address, bool is_camera) : address_(std::move(address)), is_camera_(is_camera) {}

  /// Adds the samples that one poll of the device returned, and the device's status after it. `seconds`: time
  /// since the start.
  void take(const std::vector<DeviceSample>& samples, const DeviceStatus& status, double seconds);
  /// Returns the report on the device as text. Each line that compares its records with its protocol begins
  /// with "fits", "DOES NOT FIT" or "not seen".
  std::string text() const;
  /// Returns whether records arrived and none of them contradicts the device's protocol, so that text() has
  /// no line with "DOES NOT FIT".
  bool fits() const;

 private:
  struct Station {
    std::vector<std::int64_t> times_ns;
    Vec3 low = Vec3::Zero(), high = Vec3::Zero(), last = Vec3::Zero();
    std::uint64_t poses = 0, falling_stamps = 0, jumps = 0, bent = 0, odd_quaternions = 0, errors = 0;
    double longest_step = 0;  // m
    std::array<double, fingers> least{}, most{};
    std::array<std::uint16_t, fingers> least_raw{}, most_raw{};
    std::map<Gesture, std::uint64_t> gestures;
    std::uint32_t buttons = 0;
  };
  struct Line {
    const char* verdict;
    std::string what;
  };

  void take(const DeviceSample& sample);
  std::vector<Line> lines() const;
  void judge(std::uint32_t number, const Station& station, std::vector<Line>& out) const;
  /// Returns the report's line on missing records: `dropped` are missing according to the device, `count`
  /// arrived.
  Line missing(std::uint64_t dropped, std::size_t count) const;

  std::string address_;
  bool is_camera_;
  double seconds_ = 0;
  DeviceStatus status_;
  std::vector<std::string> states_;  // each change of state, as text
  std::map<std::uint32_t, Station> stations_;
};

}  // namespace prosector
