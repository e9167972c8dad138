#pragma once
// A user's face before a camera as a tracker. Station 1 is the point between the eyes, which looks where the
// face does. Stations 2 and 3 are the right and the left eye.

#include <memory>

#include "drivers/camera/face/eyes_filter.h"
#include "drivers/camera/face/face_follower.h"
#include "drivers/camera/picture_lens.h"
#include "drivers/camera/shared_camera.h"
#include "drivers/camera_samples.h"
#include "drivers/pose_chain.h"

namespace prosector {

class FaceDevice final : public Device {
 public:
  /// Opens the camera on a thread of its own, unless the configuration has one that others see by, too.
  /// Throws InputError where the network or the lens' file can't be read.
  FaceDevice(const std::string& camera, const DeviceConfig& config);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  void see(const Frame& frame);
  DeviceSample sample_of(std::size_t station, const Pose& camera_eye, std::int64_t time_ns) const;

  const std::shared_ptr<SharedCamera> camera_;
  const double eye_distance_;  // m

  // Only the camera's thread uses these.
  FaceFinder finder_;
  PictureLens lens_;
  FaceFollower follower_;
  EyesFilter filter_;
  PoseChain chain_;
  std::uint64_t records_ = 0;

  CameraSamples samples_;
  std::unique_ptr<SharedCamera::Seat> seat_;  // last: it uses what is above
};

/// Opens a face before a camera, "face:0".
std::unique_ptr<Device> open_face(const std::string& path, const DeviceConfig& config);

}  // namespace prosector
