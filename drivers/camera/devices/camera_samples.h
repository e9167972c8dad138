#pragma once
// Samples that a camera thread detects in images, for a poller on another thread, and the camera's status.

#include <deque>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "drivers/camera/capture/camera_thread.h"
#include "drivers/device/device.h"
#include "drivers/device/health_monitor.h"

namespace prosector {

class CameraSamples {
 public:
  /// Stores the samples that the camera thread detected in the image captured at `time_ns`. If `counts` is
  /// true, the image counts as a received record in the device's health.
  void put(std::int64_t time_ns, bool counts, std::span<const DeviceSample> found);
  /// Sets whether the lens parameters are guessed. If so, status() warns that the camera is not calibrated.
  void set_guessed(bool guessed);

  /// Appends the stored samples in order and updates the device's health from the camera's state. Only one
  /// thread may call poll() and status().
  void poll(const CameraState& camera, std::vector<DeviceSample>& out);
  /// Returns the device's status with a message for the user. `problem` is the reason why a camera of the
  /// device is not open. `unseen` is the message for the case that nothing was detected for a second.
  DeviceStatus status(const std::string& problem, const char* unseen) const;

 private:
  mutable std::mutex mutex_;  // guards the members below
  std::deque<DeviceSample> found_;
  std::vector<std::int64_t> frames_ns_;  // capture times of images since the last poll
  std::int64_t seen_ns_ = 0;             // capture time of the last image with a detection
  bool is_guessed_ = false;

  HealthMonitor health_;  // used by the polling thread only, as is opened_
  std::uint64_t opened_ = 0;
};

}  // namespace prosector
