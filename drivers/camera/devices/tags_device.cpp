#include "drivers/camera/devices/tags_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/device/plausible.h"
#include "drivers/device/station_sample.h"

namespace prosector {
namespace {

constexpr std::size_t max_queued_samples = 256;  // queued samples; the oldest is dropped first
constexpr std::size_t most_frames = 64;
constexpr std::int64_t no_detection_timeout_ns = 1'000'000'000;  // time without a detection after which the
                                                                 // status reports it

}  // namespace

CameraPoseEstimator::CameraPoseEstimator(const std::string& board, const Pose& room_board)
    : room_board_(room_board), tracker_(find_board(board)) {}

void CameraPoseEstimator::update(const TagImage& picture, const TagOptics& optics) {
  const auto seen = tracker_.update(picture, optics);
  if (!seen || seen->followed) return;
  room_camera_ = filter_.update(room_board_ * seen->camera_board.inverse(), picture.time_ns);
}

TagsDevice::TagsDevice(const std::string& camera, const Placement& placement, const CameraConfig& config,
                       const BoardTrackingConfig& tags)
    : camera_(shared_camera(config.shared, camera)),
      reader_(camera_->reader(config.lens)),
      chain_(placement) {
  for (std::size_t i = 0; i < max_stations; ++i) {
    if (tags.boards[i].empty()) continue;
    stations_.push_back(
        {i, BoardTracker(find_board(tags.boards[i])), board_wearer_pose(tags.boards[i]), PoseFilter{}});
  }
  if (!config.table.empty()) place_.emplace(config.table, config.room_table);
  seat_ = std::make_unique<SharedCamera::Seat>(
      *camera_, [this](const Camera& opened) { begin(opened); }, [this](const Frame& frame) { see(frame); });
}

void TagsDevice::begin(const Camera& camera) {
  {
    const std::lock_guard lock(mutex_);
    seen_ns_ = monotonic_ns();
  }
  for (const Station& station : stations_) reader_->expect(station.tracker.board());
  if (place_) reader_->expect(place_->board());
  reader_->begin(camera);
}

void TagsDevice::see(const Frame& frame) {
  {
    const std::lock_guard lock(mutex_);
    if (frames_ns_.size() < most_frames) frames_ns_.push_back(frame.time_ns);
    is_guessed_ = reader_->is_guessed();
  }
  const TagImage& picture = reader_->read(frame);
  if (std::exchange(changes_, reader_->changes()) != reader_->changes())
    for (Station& station : stations_) station.tracker.forget();
  if (place_ && !camera_->room_camera()) {
    place_->update(picture, reader_->optics());
    if (place_->room_camera()) camera_->set_room_camera(*place_->room_camera());
  }
  std::vector<DeviceSample> found;
  std::string warning;
  for (Station& station : stations_) {
    const auto seen = station.tracker.update(picture, reader_->optics());
    if (seen) found.push_back(sample_of(station, *seen, frame.time_ns));
    int twice = 0;
    (void)corners_seen(station.tracker.board(), picture.tags, &twice);
    if (twice > 0)
      warning =
          fmt::format("board {} is detected twice: remove the other copy", station.tracker.board().name);
  }
  if (place_ && !room_camera()) {
    found.clear();
    warning = unknown_camera_pose;
  }
  const std::lock_guard lock(mutex_);
  for (const DeviceSample& sample : found) {
    if (found_.size() == max_queued_samples) found_.pop_front();
    found_.push_back(sample);
  }
  if (!found.empty()) seen_ns_ = frame.time_ns;
  warning_ = std::move(warning);
}

/// Returns the camera pose: the one shared with other devices on the camera, otherwise the one from the
/// table's board.
std::optional<Pose> TagsDevice::room_camera() const {
  if (const auto known = camera_->room_camera()) return known;
  return place_ ? place_->room_camera() : std::nullopt;
}

DeviceSample TagsDevice::sample_of(Station& station, const TrackedBoard& seen, std::int64_t time_ns) const {
  const Pose device = device_camera * seen.camera_board;
  DeviceSample out;
  out.station = static_cast<std::uint32_t>(station.index);
  out.record = station.records++;
  out.time_ns = time_ns;
  out.has_pose = true;
  out.raw_pose = raw_pose_of(device);
  const Pose worn = device * station.worn;
  const std::optional<Pose> camera = room_camera();
  out.pose = station.filter.update(
      camera ? chain_.from(*camera * device_camera, worn, station.index) : chain_.room(worn, station.index),
      time_ns);
  return out;
}

void TagsDevice::poll(std::vector<DeviceSample>& out) {
  const CameraState camera = camera_->state();
  const std::int64_t now_ns = monotonic_ns();
  if (camera.opened > opened_) health_.opened(now_ns);
  opened_ = camera.opened;
  {
    const std::lock_guard lock(mutex_);
    const auto bytes = static_cast<std::size_t>(3 * camera.width * camera.height);
    for (const std::int64_t time_ns : frames_ns_) health_.record(std::max(time_ns, now_ns - 1), bytes);
    frames_ns_.clear();
    const std::size_t before = out.size();
    out.insert(out.end(), found_.begin(), found_.end());
    found_.clear();
    health_.garbage(now_ns, remove_implausible(out, before));
  }
  if (opened_ > 0 && !camera.is_open) health_.lost();
}

DeviceStatus TagsDevice::status() const {
  const CameraState camera = camera_->state();
  DeviceStatus out = health_.status(monotonic_ns());
  const std::lock_guard lock(mutex_);
  if (!camera.problem.empty())
    out.message = camera.problem;
  else if (out.health == DeviceHealth::silent)
    out.message = "the camera is open but delivers no images: unplug it and plug it in again";
  else if (!warning_.empty())
    out.message = warning_;
  else if (out.health == DeviceHealth::streaming && monotonic_ns() - seen_ns_ > no_detection_timeout_ns)
    out.message = "no board detected: provide light, and show the board whole and flat in the image";
  else if (is_guessed_)
    out.message =
        "the camera is not calibrated: positions have an error of about 10 % (prosector-client camera "
        "calibrate)";
  return out;
}

std::unique_ptr<Device> open_tags(const std::string& path, const Placement& placement,
                                  const CameraConfig& config, const BoardTrackingConfig& tags) {
  return std::make_unique<TagsDevice>(path, placement, config, tags);
}

}  // namespace prosector
