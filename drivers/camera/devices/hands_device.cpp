#include "drivers/camera/devices/hands_device.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "common/paths.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/device/gesture_flexions.h"
#include "drivers/device/station_sample.h"

namespace prosector {
namespace {

constexpr std::size_t most_cameras = 2;

/// Returns the size of the user's hand as a factor of the hand model.
double size_of(const HandTrackingConfig& hands) {
  return hands.hand_length ? *hands.hand_length / middle_fingertip(right_hand, {}).norm() : 1;
}

}  // namespace

HandsDevice::HandsDevice(const std::vector<std::string>& cameras, const Placement& placement,
                         const CameraConfig& config, const HandTrackingConfig& hands,
                         const GestureThresholds& gestures)
    : camera_rig_(cameras.size()),
      tracker_(default_data_dir() / "models", hands.hand_nets, cameras.size(),
               {size_of(hands), hands.farthest_hand}),
      chain_(placement),
      needs_table_pose_(config.shared && !config.table.empty()),
      gestures_{GestureDetector(gestures), GestureDetector(gestures)} {
  lenses_.emplace_back(config.lens);
  if (cameras.size() > 1) {
    lenses_.emplace_back(hands.second_lens);
    camera_rig_[1] = device_camera * hands.first_second.inverse() * device_camera;
  }
  for (std::size_t k = 0; k < cameras.size(); ++k)
    cameras_.push_back(shared_camera(config.shared, cameras[k]));
  for (std::size_t k = 0; k < cameras.size(); ++k)
    seats_.push_back(std::make_unique<SharedCamera::Seat>(
        *cameras_[k], [this, k](const Camera& opened) { lenses_[k].begin(opened); },
        [this, k](const Frame& frame) { see(k, frame); }));
}

void HandsDevice::see(std::size_t camera, const Frame& frame) {
  const bool placed = !needs_table_pose_ || cameras_[0]->room_camera();
  std::vector<DeviceSample> found;
  {
    const std::lock_guard lock(looking_);
    if (lenses_[camera].take(frame.image))
      tracker_.set_camera_setup(camera, {lenses_[camera].lens(), camera_rig_[camera]});
    for (const TrackedHand& tracked : tracker_.see(camera, frame))
      if (placed) found.push_back(sample_of(tracked, frame.time_ns));
    if (camera == 0) lack_ = tracker_.lack();
  }
  samples_.put(frame.time_ns, camera == 0, found);
  if (camera == 0) samples_.set_guessed(lenses_[0].is_guessed());
  if (camera == 0) is_placed_ = placed;
}

DeviceSample HandsDevice::sample_of(const TrackedHand& tracked, std::int64_t time_ns) {
  const std::size_t station = tracked.hand == right_hand ? 0 : 1;
  const Pose wrist = device_camera * tracked.wrist;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station);
  out.record = records_[station]++;
  out.time_ns = time_ns;
  out.has_pose = out.has_flexion = true;
  out.pose = room_hand(wrist, station);
  out.raw_pose = raw_pose_of(wrist);
  out.flexion = tracked.flexion;
  out.gesture = gestures_[station].update(gesture_flexions(tracked.flexion));
  return out;
}

/// Maps a wrist into the room, with the camera's pose from another device if available, else with the
/// configured pose.
Pose HandsDevice::room_hand(const Pose& wrist, std::size_t station) const {
  const std::optional<Pose> camera = cameras_[0]->room_camera();
  return camera ? chain_.from(*camera * device_camera, wrist, station) : chain_.room(wrist, station);
}

void HandsDevice::poll(std::vector<DeviceSample>& out) {
  samples_.poll(cameras_[0]->state(), out);
}

DeviceStatus HandsDevice::status() const {
  std::string problem;
  for (std::size_t k = 0; k < cameras_.size() && problem.empty(); ++k) problem = cameras_[k]->state().problem;
  return samples_.status(problem, is_placed_ ? lack_.load() : unknown_camera_pose);
}

std::unique_ptr<Device> open_hands(const std::string& path, const Placement& placement,
                                   const CameraConfig& config, const HandTrackingConfig& hands,
                                   const GestureThresholds& gestures) {
  std::vector<std::string> cameras;
  for (std::size_t from = 0; from <= path.size();) {
    const std::size_t to = std::min(path.find(',', from), path.size());
    cameras.push_back(path.substr(from, to - from));
    from = to + 1;
  }
  if (cameras.size() > most_cameras ||
      std::any_of(cameras.begin(), cameras.end(), [](const auto& c) { return c.empty(); }))
    throw InputError(
        fmt::format("device 'hands:{}': must be hands:CAMERA or hands:CAMERA,CAMERA, as in hands:0", path));
  return std::make_unique<HandsDevice>(cameras, placement, config, hands, gestures);
}

}  // namespace prosector
