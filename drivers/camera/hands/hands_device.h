#pragma once
// Bare hands before one or two cameras, without gloves: the right hand is station 1, the left one station 2.
// Each has a pose, bends and a gesture.

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

#include "drivers/camera/camera_calibration.h"
#include "drivers/camera/hands/hand_tracker.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/gesture.h"
#include "drivers/health_monitor.h"
#include "drivers/pose_chain.h"

namespace prosector {

class HandsDevice final : public Device {
 public:
  /// Opens each camera on a thread of its own, unless the configuration has it for others, too. Throws
  /// InputError where the networks or a lens' file can't be read.
  HandsDevice(const std::vector<std::string>& cameras, const DeviceConfig& config);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  /// What is known of a camera; only its thread uses this.
  struct Lenses {
    std::optional<CameraCalibration> calibration;  // from a file, or a synthetic camera's own
    bool from_file = false;
    int width = 0, height = 0;  // of its pictures so far
  };
  void begin(std::size_t camera, const Camera& opened);
  void see(std::size_t camera, const Frame& frame);
  void make_ready(std::size_t camera, const Frame& frame);
  DeviceSample sample_of(const TrackedHand& tracked, std::int64_t time_ns);
  Pose room_hand(const Pose& wrist, std::size_t station) const;

  std::vector<Lenses> lenses_;
  std::vector<Pose> camera_rig_;  // the first camera's frame in each one's
  std::mutex looking_;            // two cameras' threads look one after the other
  HandTracker tracker_;
  PoseChain chain_;
  std::array<GestureDetector, 2> gestures_;  // of stations
  std::array<std::uint64_t, 2> records_{};

  mutable std::mutex mutex_;  // guards what follows
  std::deque<DeviceSample> found_;
  std::vector<std::int64_t> frames_ns_;  // of the first camera's pictures since the last poll
  std::int64_t seen_ns_ = 0;             // of the last picture that showed a hand
  bool is_guessed_ = false;              // a lens

  HealthMonitor health_;  // of who polls, as is the next
  std::uint64_t opened_ = 0;
  std::vector<std::shared_ptr<SharedCamera>> cameras_;
  std::vector<std::unique_ptr<SharedCamera::Seat>> seats_;  // last: they use what is above
};

/// Opens hands before cameras, "hands:0" or "hands:0,2".
std::unique_ptr<Device> open_hands(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
