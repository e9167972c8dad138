#pragma once
// What a camera's thread makes of pictures, for who polls on another one; and how the camera is.

#include <deque>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "drivers/camera/camera_thread.h"
#include "drivers/device.h"
#include "drivers/health_monitor.h"

namespace prosector {

class CameraSamples {
 public:
  /// Takes what was found in a picture of that time. `counts`: the picture is a record of the device.
  void put(std::int64_t time_ns, bool counts, std::span<const DeviceSample> found);
  /// Says whether the lens is guessed.
  void set_guessed(bool guessed);

  /// Takes out what came, in order, and judges the camera. One thread alone calls this and status().
  void poll(const CameraState& camera, std::vector<DeviceSample>& out);
  /// Returns how the camera is; `problem`: why it isn't open, of this one or another; `unseen`: what to say
  /// where nothing was found for a while.
  DeviceStatus status(const std::string& problem, const char* unseen) const;

 private:
  mutable std::mutex mutex_;  // guards what follows
  std::deque<DeviceSample> found_;
  std::vector<std::int64_t> frames_ns_;  // of pictures since the last poll
  std::int64_t seen_ns_ = 0;             // of the last picture in which something was found
  bool is_guessed_ = false;

  HealthMonitor health_;  // of who polls, as is the next
  std::uint64_t opened_ = 0;
};

}  // namespace prosector
