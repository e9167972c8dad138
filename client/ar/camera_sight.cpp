#include "client/ar/camera_sight.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "client/ar/paper_light.h"
#include "common/clock.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/camera/tags/standard_boards.h"

namespace prosector {
namespace {

constexpr double light_time_constant = 0.5;  // s, time constant of the light estimate
constexpr double silent = 1.5;               // s without an image, after which a problem is reported

double seconds_between(std::int64_t from_ns, std::int64_t to_ns) {
  return 1e-9 * static_cast<double>(to_ns - from_ns);
}

}  // namespace

CameraSight::CameraSight(std::shared_ptr<SharedCamera> camera, const CameraConfig& config,
                         const std::optional<ObjectBoard>& tablet, const std::optional<ObjectBoard>& phantom)
    : camera_(std::move(camera)),
      room_board_(config.room_table),
      reader_(camera_->reader(config.lens)),
      tracker_(find_board(config.table.empty() ? "table" : config.table)),
      tablet_(tablet ? std::optional<BoardTracker>(find_board(tablet->board)) : std::nullopt),
      tablet_panel_(tablet ? board_wearer_pose(tablet->board) * tablet->mount : Pose{}),
      phantom_(phantom ? std::optional<BoardTracker>(find_board(phantom->board)) : std::nullopt),
      board_phantom_(phantom ? phantom->mount : Pose{}),
      seat_(
          *camera_,
          [this](const Camera& opened) {
            reader_->expect(tracker_.board());
            reader_->begin(opened);
          },
          [this](const Frame& frame) { see(frame); }, true) {}

void CameraSight::see(const Frame& frame) {
  const TagImage& picture = reader_->read(frame);
  const TagOptics& optics = reader_->optics();
  if (std::exchange(changes_, reader_->changes()) != reader_->changes()) {
    tracker_.forget();
    if (tablet_) tablet_->forget();
    if (phantom_) phantom_->forget();
    last_eye_.reset();
  }
  auto out = std::make_shared<UndistortedImage>();
  out->image = std::make_shared<const Image>(reader_->straightener().straight(frame.image));
  out->bent = optics.bent;
  out->straight = optics.straight;
  out->time_ns = frame.time_ns;
  if (const auto seen = tracker_.update(picture, optics)) {
    last_eye_ = room_board_ * seen->camera_board.inverse() * device_camera;
    if (const auto paper = paper_light(*out->image, optics.straight, tracker_.board(), seen->camera_board)) {
      const double share = 1 - std::exp(-seconds_between(seen_ns_, frame.time_ns) / light_time_constant);
      paper_ = paper_ ? Vec3(*paper_ + share * (*paper - *paper_)) : *paper;
    }
    seen_ns_ = frame.time_ns;
  }
  if (seconds_between(seen_ns_, frame.time_ns) < held) out->room_eye = last_eye_;
  if (out->room_eye) find_boards(*out, picture);
  out->room_phantom = room_phantom_;
  out->paper = paper_;
  {
    const std::lock_guard lock(mutex_);
    out->number = newest_ ? newest_->number + 1 : 1;
    newest_ = std::move(out);
  }
  image_available_.notify_one();
}

/// Publishes the camera's pose and detects the boards of tablet and phantom. A phantom whose board isn't
/// detected keeps its last pose.
void CameraSight::find_boards(UndistortedImage& out, const TagImage& picture) {
  const Pose room_camera = *out.room_eye * device_camera;
  camera_->set_room_camera(room_camera);
  const auto tablet = tablet_ ? tablet_->update(picture, reader_->optics()) : std::nullopt;
  if (tablet) out.room_tablet = room_camera * tablet->camera_board * tablet_panel_;
  const auto phantom = phantom_ ? phantom_->update(picture, reader_->optics()) : std::nullopt;
  if (phantom) room_phantom_ = room_camera * phantom->camera_board * board_phantom_;
}

std::shared_ptr<const UndistortedImage> CameraSight::next(std::chrono::milliseconds time_limit) {
  std::unique_lock lock(mutex_);
  image_available_.wait_for(lock, time_limit, [this] { return newest_ && newest_->number > taken_; });
  if (newest_) taken_ = newest_->number;
  return newest_;
}

std::string CameraSight::warning(const Catalogue& words) const {
  const CameraState camera = camera_->state();
  if (!camera.problem.empty()) return words.tr("camera {}", camera.problem);
  const std::lock_guard lock(mutex_);
  if (!newest_ || seconds_since(newest_->time_ns) > silent)
    return words.tr("the camera delivers no images: check that it is connected");
  if (!newest_->room_eye)
    return words.tr(
        "the board \"{}\" is not detected: provide light, and show it flat and complete in the image",
        tracker_.board().name);
  return {};
}

}  // namespace prosector
