#include "drivers/camera/face/face_device.h"

#include <array>

#include "common/paths.h"
#include "drivers/camera/camera_frames.h"
#include "drivers/station_sample.h"

namespace prosector {
FaceDevice::FaceDevice(const std::string& camera, const DeviceConfig& config)
    : camera_(shared_camera(config.camera, camera)),
      eye_distance_(config.eye_distance),
      finder_(default_data_dir() / "models"),
      lens_(config.lens),
      chain_(config) {
  seat_ = std::make_unique<SharedCamera::Seat>(
      *camera_, [this](const Camera& opened) { lens_.begin(opened); },
      [this](const Frame& frame) { see(frame); });
}

void FaceDevice::see(const Frame& frame) {
  (void)lens_.take(frame.image);
  std::vector<DeviceSample> found;
  std::vector<PlacedFace> faces;
  for (const FoundFace& face : finder_.find_all(frame.image))
    faces.push_back({face.score, place_eyes(face, lens_.lens(), eye_distance_)});
  if (const auto eyes = follower_.follow(faces, frame.time_ns)) {
    const Pose head = filter_.update(eyes->head, frame.time_ns);
    const std::array<double, 3> sides = {0, eye_distance_ / 2, -eye_distance_ / 2};  // to the user's right
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
  // Others who look by this camera may know where it stands.
  const std::optional<Pose> camera = camera_->room_camera();
  out.pose = camera ? chain_.from(*camera * device_camera, eye, station) : chain_.room(eye, station);
  return out;
}

void FaceDevice::poll(std::vector<DeviceSample>& out) {
  samples_.poll(camera_->state(), out);
}

DeviceStatus FaceDevice::status() const {
  return samples_.status(camera_->state().problem,
                         "no face is seen: is there light, and are both eyes and the nose in the picture?");
}

std::unique_ptr<Device> open_face(const std::string& path, const DeviceConfig& config) {
  return std::make_unique<FaceDevice>(path, config);
}

}  // namespace prosector
