#include "client/app/run/camera_mode.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "client/ar/camera_view.h"
#include "common/anatomy/surface_io.h"

namespace prosector {
namespace {

/// Returns the board on the user's tablet, if a camera tracks it.
std::optional<ObjectBoard> tablet_board(const ClientConfig& devices) {
  if (devices.tracker.empty() || !driver_of(devices.tracker).is_camera) return std::nullopt;
  for (std::size_t k = 0; k < max_stations; ++k)
    if (devices.stations[k] == StationRole::tablet)
      return ObjectBoard{devices.tracker_device.tags.boards[k], devices.tracker_device.placement.mount[k]};
  return std::nullopt;
}

}  // namespace

CameraMode::CameraMode(ViewerContext& client, std::unique_ptr<ScreenMode> screen,
                       const std::shared_ptr<SharedCamera>& camera)
    : GuidedMode(client, std::move(screen)) {
  const ClientConfig& devices = client.options.devices;
  const auto phantom_board = take_phantom();
  sight_ = std::make_unique<CameraSight>(camera, devices.tracker_device.camera, tablet_board(devices),
                                         phantom_board);
  if (!client.options.logs.pictures.empty()) log_.emplace(client.options.logs.pictures);
}

/// Sets up the calibrated phantom, if any. Returns its board.
std::optional<ObjectBoard> CameraMode::take_phantom() {
  const PhantomSettings& phantom = client_.options.devices.phantom;
  if (!phantom.has_place()) return std::nullopt;
  phantom_.emplace();
  phantom_->body = phantom.body;
  if (!phantom.mesh.empty())
    phantom_->shape = std::make_shared<const TriangleMesh>(load_surface(phantom.mesh, phantom.scale));
  if (!phantom.board.empty()) return ObjectBoard{phantom.board, phantom.pose.value_or(Pose{})};
  phantom_->place = phantom.pose;
  return std::nullopt;
}

bool CameraMode::begin_frame() {
  constexpr std::chrono::milliseconds time_limit(100);
  image_ = sight_->next(time_limit);
  waited_ = true;
  if (should_skip_frame()) return false;
  update_overlay();
  return true;
}

/// Returns whether to skip this camera image to respect --fps; if not, sets the time of the next one. An
/// image up to half an interval early is accepted, because camera and computer clocks differ.
bool CameraMode::should_skip_frame() {
  const auto interval_ns = static_cast<std::int64_t>(1e9 / client_.options.display.frames_per_second);
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns + interval_ns / 2 < due_ns_) return true;
  due_ns_ = std::max(due_ns_, now_ns - interval_ns / 2) + interval_ns;
  return false;
}

/// Sets the background and the camera pose from the latest image, and reports new problems.
void CameraMode::update_overlay() {
  CameraOverlay now;
  now.room_board = sight_->room_board();
  now.words = sight_->warning(client_.options.words);
  now.phantoms = client_.options.ar.phantoms;
  now.found = phantom_;
  now.camera.width = context().width();
  now.camera.height = context().height();
  if (image_) {
    const CameraView view = view_of(image_->bent, image_->straight, now.camera.width, now.camera.height);
    now.camera = view.camera;
    now.backdrop = {image_->image, image_->number, view.left, view.top, view.step};
    now.is_placed = image_->room_eye.has_value();
    now.camera.pose = image_->room_eye.value_or(Pose{});
    now.paper = image_->paper;
    now.room_tablet = image_->room_tablet;
    if (now.found && image_->room_phantom) now.found->place = image_->room_phantom;
  }
  if (now.words != (overlay_ ? overlay_->words : ""))
    client_.inform(
        now.words.empty()
            ? client_.options.words.tr("the camera has found the table board, which defines the room frame")
            : now.words);
  overlay_ = std::move(now);
}

void CameraMode::wait_for_inputs(const InputPump* pump) {
  if (pump != nullptr && image_ && has_devices(client_.options.devices))
    wait_for_hands(*pump, image_->time_ns);
}

/// Waits up to 300 ms until all image analysers have processed the image captured at `time_ns`, then up to 20
/// ms for the resulting hand poses. Hands that are absent or tracked by other devices cause no new poses.
void CameraMode::wait_for_hands(const InputPump& pump, std::int64_t time_ns) const {
  constexpr std::chrono::milliseconds poll_period(2);
  constexpr int max_analysis_polls = 150, max_pose_polls = 10;
  for (int polls = 0; polls < max_analysis_polls && !sight_->all_analysed(time_ns); ++polls)
    std::this_thread::sleep_for(poll_period);
  for (int polls = 0; polls < max_pose_polls && pump.latest().time_ns < time_ns; ++polls)
    std::this_thread::sleep_for(poll_period);
}

Outlook CameraMode::look(InputPump* pump, LocalUser& self, const Outlook& usual) {
  // The pointer's rays start at the real camera's pose.
  screen_->follow_camera(overlay_ && overlay_->is_placed ? std::optional(overlay_->camera) : std::nullopt);
  Outlook out = screen_->look(pump, self, usual);
  if (!overlay_) return out;
  out.projection = *overlay_;
  out.eye = usual.eye;
  out.pointed = screen_->pointed();
  return out;
}

void CameraMode::show(Renderer& /*renderer*/, const FrameTimes& times) {
  if (!log_ || !image_) return;
  FrameTimes logged = times;
  logged.drawn_ns = monotonic_ns();
  logged.camera_ns = image_->time_ns;
  log_->add(logged);
}

void CameraMode::show_loading(Renderer& renderer, const LoadingState& state) {
  waited_ = false;
  screen_->show_loading(renderer, state);
}

}  // namespace prosector
