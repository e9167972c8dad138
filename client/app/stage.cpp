#include "client/app/stage.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>

#include "common/anatomy/surface_io.h"
#include "common/error.h"

namespace prosector {
namespace {

// On a shared machine the simulation has the first call: pictures can wait a frame, physics can't. Threads
// that start after this (the software renderer's) inherit it; those that carry hands and snapshots run
// already.
void yield_to_simulation() {
  setpriority(PRIO_PROCESS, 0, 5);
}

/// Describes what watchers see: in stereo, one eye's picture as the profile's display shows it; a headset's
/// left eye's as it is.
Audience audience_of(const ClientOptions& o) {
  Audience out = *o.audience;
  if (o.display == Display::openxr) out.eyes = 2;
  if (o.display == Display::stereo) {
    out.eyes = 2;
    out.aspect = std::tan(o.stereo.fov_horizontal / 2) / std::tan(o.stereo.fov_vertical / 2);
  }
  return out;
}

/// Returns the board that is the user's tablet, where a camera tracks it.
std::optional<SightBoard> tablet_before(const ClientConfig& devices) {
  if (devices.tracker.empty() || !driver_of(devices.tracker).is_camera) return std::nullopt;
  for (std::size_t k = 0; k < max_stations; ++k)
    if (devices.stations[k] == StationRole::tablet)
      return SightBoard{devices.tracker_device.boards[k], devices.tracker_device.mount[k]};
  return std::nullopt;
}

/// Takes the phantom whose place was found, and looks from then on through the camera, also for its board.
void look_through(Stage& stage, const ClientConfig& devices, const std::shared_ptr<SharedCamera>& camera) {
  const PhantomSettings& phantom = devices.phantom;
  std::optional<SightBoard> board;
  if (phantom.has_place()) {
    stage.phantom.emplace();
    stage.phantom->body = phantom.body;
    if (!phantom.mesh.empty())
      stage.phantom->shape = std::make_shared<const TriangleMesh>(load_surface(phantom.mesh, phantom.scale));
    if (phantom.board.empty())
      stage.phantom->place = phantom.pose;
    else
      board = {phantom.board, phantom.pose.value_or(Pose{})};
  }
  stage.sight = std::make_unique<CameraSight>(camera, devices.tracker_device, tablet_before(devices), board);
}

/// Makes the context that a headset's runtime can draw with, with a window where somebody watches or where
/// the runtime wants one.
void make_headset_context(Stage& stage, const ClientOptions& o) {
  const bool by_egl = headset_takes_egl();
  if (by_egl && !o.audience) {
    stage.context = make_egl_context(o.width, o.height);
    return;
  }
  const auto audience = o.audience ? std::optional(audience_of(o)) : std::nullopt;
  try {
    auto mirror =
        make_mirror_context(by_egl ? WindowSystem::egl : WindowSystem::glx, o.width, o.height, audience);
    stage.mirror = mirror.get();
    stage.context = std::move(mirror);
  } catch (const InputError& error) {
    throw InputError(fmt::format(
        "--display openxr: {}: {}",
        by_egl ? "--audience wants a window" : "the runtime takes pictures by GLX alone", error.what()));
  }
}

}  // namespace

std::unique_ptr<Stage> make_stage(const ClientOptions& o, HeadsetUser& user,
                                  const std::shared_ptr<SharedCamera>& camera) {
  if (o.display == Display::none) return nullptr;
  yield_to_simulation();
  auto stage = std::make_unique<Stage>();
  if (o.display == Display::openxr) {
    make_headset_context(*stage, o);
    stage->headset = std::make_unique<Headset>(*stage->context, o.devices.headset_room,
                                               [&user](const TrackedUser& now) { user.put(now); });
  } else if (o.display == Display::offscreen) {
    stage->context = make_offscreen_context(o.width, o.height);
  } else if (o.display == Display::osmesa) {
    stage->context = make_osmesa_context(o.width, o.height);
  } else {
    auto window = make_window_context(o.width, o.height, "Prosector: " + o.bus.session);
    stage->desk =
        std::make_unique<Desk>(*window, DeskChoices{.shown = o.shown, .full_screen = o.monitor.has_value()});
    stage->window = window.get();
    if (o.audience) window->open_audience(audience_of(o));
    stage->context = std::move(window);
  }
  if (!o.camera.empty()) look_through(*stage, o.devices, camera);
  if (WindowSettings window = o.devices.window; !window.address.empty()) {
    window.device.camera = camera;
    stage->eyes = std::make_unique<EyeWindow>(window);
  }
  stage->renderer = std::make_unique<Renderer>(*stage->context, o.shaders, o.quality.settings);
  return stage;
}

}  // namespace prosector
