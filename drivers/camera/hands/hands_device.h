#pragma once
// Bare hands before one or two cameras, without gloves: the right hand is station 1, the left one station 2.
// Each has a pose, bends and a gesture.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "drivers/camera/hands/hand_tracker.h"
#include "drivers/camera/picture_lens.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/camera_samples.h"
#include "drivers/gesture.h"
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
  void see(std::size_t camera, const Frame& frame);
  DeviceSample sample_of(const TrackedHand& tracked, std::int64_t time_ns);
  Pose room_hand(const Pose& wrist, std::size_t station) const;

  std::vector<PictureLens> lenses_;  // each of its camera's thread
  std::vector<Pose> camera_rig_;     // the first camera's frame in each one's
  std::mutex looking_;               // two cameras' threads look one after the other
  HandTracker tracker_;
  PoseChain chain_;
  const bool awaits_table_;                  // others look for the board that says where the camera stands
  std::array<GestureDetector, 2> gestures_;  // of stations
  std::array<std::uint64_t, 2> records_{};

  CameraSamples samples_;
  std::atomic<const char*> lack_ =
      "";  // why the first camera's last picture gave no hand; empty: it gave one
  std::atomic<bool> is_placed_ = true;  // it is known where the first camera stands
  std::vector<std::shared_ptr<SharedCamera>> cameras_;
  std::vector<std::unique_ptr<SharedCamera::Seat>> seats_;  // last: they use what is above
};

/// Opens hands before cameras, "hands:0" or "hands:0,2".
std::unique_ptr<Device> open_hands(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
