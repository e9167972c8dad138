#include "drivers/camera/devices/face_device.h"

#include <array>

#include "common/paths.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/device/station_sample.h"

namespace prosector {
FaceDevice::FaceDevice(const std::string& camera, const Placement& placement, const CameraConfig& config,
                       const FaceTrackingConfig& face)
    : camera_(shared_camera(config.shared, camera)),
      eye_distance_(face.eye_distance),
      finder_(default_data_dir() / "models"),
      lens_(config.lens),
      chain_(placement) {
  seat_ = std::make_unique<SharedCamera::Seat>(
      *camera_, [this](const Camera& opened) { lens_.begin(opened); },
      [this](const Frame& frame) { see(frame); });
}

void FaceDevice::see(const Frame& frame) {
  (void)lens_.take(frame.image);
  std::vector<DeviceSample> found;
  std::vector<PlacedFace> faces;
  for (const DetectedFace& face : finder_.find_all(frame.image))
    faces.push_back({face.score, estimate_eyes_pose(face, lens_.lens(), eye_distance_)});
  if (const auto eyes = follower_.follow(faces, frame.time_ns)) {
    const Pose head = filter_.update(eyes->head, frame.time_ns);
    const std::array<double, 3> sides = {0, eye_distance_ / 2, -eye_distance_ / 2};  // m, to the user's right
    for (std::size_t station = 0; station < sides.size(); ++station)
      found.push_back(
          sample_of(station, head * Pose{{sides[station], 0, 0}, Quat::Identity()}, frame.time_ns));
    ++records_;
  }
  samples_.put(frame.time_ns, true, found);
  samples_.set_guessed(lens_.is_guessed());
}

DeviceSample FaceDevice::sample_of(std::size_t station, const Pose& camera_eye, std::int64_t time_ns) const {
  const Pose eye = device_camera * camera_eye;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station);
  out.record = records_;
  out.time_ns = time_ns;
  out.has_pose = true;
  out.raw_pose = raw_pose_of(eye);
  // Another user of the shared camera may know the camera's pose in the room.
  const std::optional<Pose> camera = camera_->room_camera();
  out.pose = camera ? chain_.from(*camera * device_camera, eye, station) : chain_.room(eye, station);
  return out;
}

void FaceDevice::poll(std::vector<DeviceSample>& out) {
  samples_.poll(camera_->state(), out);
}

DeviceStatus FaceDevice::status() const {
  return samples_.status(camera_->state().problem,
                         "no face detected: provide light, and keep both eyes and the nose in the image");
}

std::unique_ptr<Device> open_face(const std::string& path, const Placement& placement,
                                  const CameraConfig& config, const FaceTrackingConfig& face) {
  return std::make_unique<FaceDevice>(path, placement, config, face);
}

}  // namespace prosector
