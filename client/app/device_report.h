#pragma once
// What a device did for a while, against what its protocol promises: for people who have one, to read and to
// send on.

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "drivers/device.h"

namespace prosector {

class DeviceReport {
 public:
  /// Makes a report without records. Records of a device that `is_camera` come from images. An image in which
  /// nothing is found, or that the computer has no time to evaluate, gives none, and that is no fault.
  DeviceReport(std::string address, bool is_camera) : address_(std::move(address)), is_camera_(is_camera) {}

  /// Takes what one poll brought, and how the device was after it, `seconds` after the start.
  void take(const std::vector<DeviceSample>& samples, const DeviceStatus& status, double seconds);
  /// Returns the report. Each line about the protocol begins with "fits", "DOES NOT FIT" or "not seen".
  std::string text() const;
  /// Tells whether nothing was found that doesn't fit, and records came.
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
  /// Returns the line on missing records: `dropped` are missing, `count` arrived.
  Line missing(std::uint64_t dropped, std::size_t count) const;

  std::string address_;
  bool is_camera_;
  double seconds_ = 0;
  DeviceStatus status_;
  std::vector<std::string> states_;  // each change, in words
  std::map<std::uint32_t, Station> stations_;
};

}  // namespace prosector
