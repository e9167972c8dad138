#pragma once
// Tracker of a user's face in front of a camera. Station 1 is the point between the eyes, with the
// orientation of the face. Stations 2 and 3 are the right and the left eye.

#include <memory>

#include "drivers/camera/base/image_lens.h"
#include "drivers/camera/devices/camera_config.h"
#include "drivers/camera/devices/camera_samples.h"
#include "drivers/camera/devices/face_tracking_config.h"
#include "drivers/camera/devices/shared_camera.h"
#include "drivers/camera/face/eyes_filter.h"
#include "drivers/camera/face/face_follower.h"
#include "drivers/device/pose_chain.h"

namespace prosector {

class FaceDevice final : public Device {
 public:
  /// Opens the camera on its own thread, or uses the camera shared with other devices if the configuration
  /// has one at this address. Throws InputError if the face network's file or the lens file cannot be read.
  FaceDevice(const std::string& camera, const Placement& placement, const CameraConfig& config,
             const FaceTrackingConfig& face);

  void poll(std::vector<DeviceSample>& out) override;
  DeviceStatus status() const override;
  int descriptor() const override { return -1; }

 private:
  void see(const Frame& frame);
  DeviceSample sample_of(std::size_t station, const Pose& camera_eye, std::int64_t time_ns) const;

  const std::shared_ptr<SharedCamera> camera_;
  const double eye_distance_;  // m

  // Used only by the camera's thread.
  FaceDetector finder_;
  ImageLens lens_;
  FaceFollower follower_;
  EyesFilter filter_;
  PoseChain chain_;
  std::uint64_t records_ = 0;

  CameraSamples samples_;
  std::unique_ptr<SharedCamera::Seat> seat_;  // last member, because its callbacks use the members above
};

/// Opens a face tracker on a camera. `path` is the camera's address, such as "0" in the device address
/// "face:0".
std::unique_ptr<Device> open_face(const std::string& path, const Placement& placement,
                                  const CameraConfig& config, const FaceTrackingConfig& face);

}  // namespace prosector
