#pragma once
// Tracks bare hands in front of one or two cameras, without gloves. The right hand is station 1, the left
// hand station 2. Each has a pose, bends and a gesture.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "drivers/camera/base/image_lens.h"
#include "drivers/camera/devices/camera_config.h"
#include "drivers/camera/devices/camera_samples.h"
#include "drivers/camera/devices/hand_tracking_config.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/camera/hands/hand_tracker.h"
#include "drivers/device/gesture.h"
#include "drivers/device/pose_chain.h"

namespace prosector {

class HandsDevice final : public Device {
 public:
  /// Opens each camera on its own thread, or uses the camera shared with other devices if the configuration
  /// has one at this address. Throws InputError if the hand networks or a lens file cannot be read.
  HandsDevice(const std::vector<std::string>& cameras, const Placement& placement, const CameraConfig& config,
              const HandTrackingConfig& hands, const GestureThresholds& gestures);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  void see(std::size_t camera, const Frame& frame);
  DeviceSample sample_of(const TrackedHand& tracked, std::int64_t time_ns);
  Pose room_hand(const Pose& wrist, std::size_t station) const;

  std::vector<ImageLens> lenses_;  // each used only by its camera's thread
  std::vector<Pose> camera_rig_;   // pose of the first camera's frame in each camera's frame
  std::mutex looking_;  // held while an image is processed, so that the cameras' threads take turns
  HandTracker tracker_;
  PoseChain chain_;
  const bool needs_table_pose_;  // another device tracks the table's board, which gives the camera's pose in
                                 // the room
  std::array<GestureDetector, 2> gestures_;  // one per station
  std::array<std::uint64_t, 2> records_{};

  CameraSamples samples_;
  std::atomic<const char*> lack_ = "";  // why the first camera's last image gave no hand; empty: it gave one
  std::atomic<bool> is_placed_ = true;  // the first camera's pose in the room is known
  std::vector<std::shared_ptr<SharedCamera>> cameras_;
  std::vector<std::unique_ptr<SharedCamera::Seat>>
      seats_;  // last member, because the callbacks use the members above
};

/// Opens a tracker of bare hands on one or two cameras. `path` has the cameras' addresses, such as "0" in the
/// device address "hands:0", or "0,2".
std::unique_ptr<Device> open_hands(const std::string& path, const Placement& placement,
                                   const CameraConfig& config, const HandTrackingConfig& hands,
                                   const GestureThresholds& gestures);

}  // namespace prosector
