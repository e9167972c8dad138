#include "drivers/camera/hands/hands_device.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/clock.h"
#include "common/error.h"
#include "common/paths.h"
#include "drivers/camera/camera_frames.h"

namespace prosector {
namespace {

constexpr std::size_t most_cameras = 2;
constexpr std::size_t most_samples = 256;  // that wait: the oldest goes first
constexpr std::size_t most_frame_times = 64;
constexpr std::int64_t no_hand_ns = 1'000'000'000;  // after which it says that it sees none

GestureDetector gesture_detector(const DeviceConfig& config) {
  return GestureDetector({config.closed_above, config.open_below, config.hysteresis, config.pinch});
}

/// Returns the user's hand's size, of ours.
double size_of(const DeviceConfig& config) {
  return config.hand_length ? *config.hand_length / middle_fingertip(right_hand, {}).norm() : 1;
}

}  // namespace

HandsDevice::HandsDevice(const std::vector<std::string>& cameras, const DeviceConfig& config)
    : lenses_(cameras.size()),
      camera_rig_(cameras.size()),
      tracker_(default_data_dir() / "models", HandNets::full, cameras.size(), size_of(config)),
      chain_(config),
      gestures_{gesture_detector(config), gesture_detector(config)} {
  if (!config.lens.empty()) lenses_[0] = {load_calibration(config.lens), true, 0, 0};
  if (cameras.size() > 1) {
    if (!config.second_lens.empty()) lenses_[1] = {load_calibration(config.second_lens), true, 0, 0};
    camera_rig_[1] = device_camera * config.first_second.inverse() * device_camera;
  }
  for (std::size_t k = 0; k < cameras.size(); ++k)
    cameras_.push_back(shared_camera(config.camera, cameras[k]));
  for (std::size_t k = 0; k < cameras.size(); ++k)
    seats_.push_back(std::make_unique<SharedCamera::Seat>(
        *cameras_[k], [this, k](const Camera& opened) { begin(k, opened); },
        [this, k](const Frame& frame) { see(k, frame); }));
}

void HandsDevice::begin(std::size_t camera, const Camera& opened) {
  Lenses& known = lenses_[camera];
  known.width = known.height = 0;
  if (known.from_file) return;
  known.calibration.reset();
  if (const auto lens = opened.lens())
    known.calibration = CameraCalibration{opened.identity(), *lens, opened.response(), 0};
}

void HandsDevice::make_ready(std::size_t camera, const Frame& frame) {
  Lenses& known = lenses_[camera];
  const int width = frame.image.width, height = frame.image.height;
  if (known.width == width && known.height == height) return;
  known.width = width;
  known.height = height;
  const CameraCalibration calibration = known.calibration.value_or(guessed_calibration(width, height));
  tracker_.set_eye(camera, {calibration.lens.scaled(width, height), camera_rig_[camera]});
}

void HandsDevice::see(std::size_t camera, const Frame& frame) {
  std::vector<DeviceSample> found;
  {
    const std::lock_guard lock(looking_);
    make_ready(camera, frame);
    for (const TrackedHand& tracked : tracker_.see(camera, frame))
      found.push_back(sample_of(tracked, frame.time_ns));
  }
  const std::lock_guard lock(mutex_);
  if (camera == 0 && frames_ns_.size() < most_frame_times) frames_ns_.push_back(frame.time_ns);
  if (camera == 0) is_guessed_ = !lenses_[0].calibration;
  for (const DeviceSample& sample : found) {
    if (found_.size() == most_samples) found_.pop_front();
    found_.push_back(sample);
  }
  if (!found.empty()) seen_ns_ = frame.time_ns;
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
  out.raw_pose = {static_cast<float>(wrist.p.x()), static_cast<float>(wrist.p.y()),
                  static_cast<float>(wrist.p.z()), static_cast<float>(wrist.q.w()),
                  static_cast<float>(wrist.q.x()), static_cast<float>(wrist.q.y()),
                  static_cast<float>(wrist.q.z())};
  out.flexion = tracked.flexion;
  out.gesture = gestures_[station].update(tracked.flexion);
  return out;
}

/// Maps a wrist into the room: from where others saw that the first camera stands, else as it is configured.
Pose HandsDevice::room_hand(const Pose& wrist, std::size_t station) const {
  const std::optional<Pose> camera = cameras_[0]->room_camera();
  return camera ? chain_.from(*camera * device_camera, wrist, station) : chain_.room(wrist, station);
}

void HandsDevice::poll(std::vector<DeviceSample>& out) {
  const CameraState camera = cameras_[0]->state();
  const std::int64_t now_ns = monotonic_ns();
  const bool opened = camera.opened > opened_;
  if (opened) health_.opened(now_ns);
  opened_ = camera.opened;
  {
    const std::lock_guard lock(mutex_);
    if (opened) seen_ns_ = now_ns;  // it has just begun to look
    const auto bytes = 3 * static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
    for (const std::int64_t time_ns : frames_ns_) health_.record(std::max(time_ns, now_ns - 1), bytes);
    frames_ns_.clear();
    out.insert(out.end(), found_.begin(), found_.end());
    found_.clear();
  }
  if (opened_ > 0 && !camera.is_open) health_.lost();
}

DeviceStatus HandsDevice::status() const {
  DeviceStatus out = health_.status(monotonic_ns());
  for (const auto& camera : cameras_)
    if (const std::string problem = camera->state().problem; !problem.empty()) {
      out.message = problem;
      return out;
    }
  if (opened_ == 0) {
    out.health = DeviceHealth::connecting;
    out.message = "the camera is being opened";
    return out;
  }
  const std::lock_guard lock(mutex_);
  if (out.health == DeviceHealth::silent)
    out.message = "the camera is open and gives no pictures: unplug it and plug it in again";
  else if (out.health == DeviceHealth::streaming && monotonic_ns() - seen_ns_ > no_hand_ns)
    out.message = "no hand is seen: is there light, and is it in the picture, whole, without a glove?";
  else if (is_guessed_)
    out.message =
        "the camera isn't calibrated: places are right to a tenth or so (prosector-client camera calibrate)";
  return out;
}

std::unique_ptr<Device> open_hands(const std::string& path, const DeviceConfig& config) {
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
  return std::make_unique<HandsDevice>(cameras, config);
}

}  // namespace prosector
