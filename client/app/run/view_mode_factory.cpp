#include "client/app/run/view_mode_factory.h"

#include <algorithm>
#include <array>

#include "client/app/run/camera_mode.h"
#include "client/app/run/desk_mode.h"
#include "client/app/run/eye_window_mode.h"
#include "client/app/run/headset_mode.h"
#include "client/app/run/offscreen_mode.h"

namespace prosector {
namespace {

/// Creates the screen, which shows its own view or is guided by a device.
std::unique_ptr<ScreenMode> make_screen(const ViewModeParts& parts) {
  const ClientOptions& o = parts.client.options;
  switch (o.display.kind) {
    case Display::offscreen:
      return std::make_unique<OffscreenMode>(parts.client,
                                             make_offscreen_context(o.display.width, o.display.height));
    case Display::osmesa:
      return std::make_unique<OffscreenMode>(parts.client,
                                             make_osmesa_context(o.display.width, o.display.height));
    case Display::stereo:
      return std::make_unique<DeskMode>(parts.client, parts.scene, o.display.stereo);
    default:
      return std::make_unique<DeskMode>(parts.client, parts.scene, Mono{});
  }
}

std::unique_ptr<ViewMode> make_headset(const ViewModeParts& parts) {
  return std::make_unique<HeadsetMode>(parts.client, parts.headset_user);
}

std::unique_ptr<ViewMode> make_camera(const ViewModeParts& parts) {
  return std::make_unique<CameraMode>(parts.client, make_screen(parts), parts.camera);
}

std::unique_ptr<ViewMode> make_eye_window(const ViewModeParts& parts) {
  WindowSettings settings = parts.client.options.devices.window;
  settings.device.camera.shared = parts.camera;
  return std::make_unique<EyeWindowMode>(parts.client, make_screen(parts), settings);
}

/// A view mode, and the options that select it.
struct ViewModeRow {
  bool (*fits)(const ClientOptions&);
  std::unique_ptr<ViewMode> (*make)(const ViewModeParts&);
};

// The first row that fits counts.
constexpr std::array view_mode_rows{
    ViewModeRow{[](const ClientOptions& o) { return o.display.kind == Display::openxr; }, make_headset},
    ViewModeRow{[](const ClientOptions& o) { return !o.ar.camera.empty(); }, make_camera},
    ViewModeRow{[](const ClientOptions& o) { return !o.devices.window.address.empty(); }, make_eye_window},
    ViewModeRow{[](const ClientOptions&) { return true; },
                [](const ViewModeParts& parts) -> std::unique_ptr<ViewMode> { return make_screen(parts); }},
};

}  // namespace

std::unique_ptr<ViewMode> make_view_mode(const ViewModeParts& parts) {
  const auto row = std::ranges::find_if(
      view_mode_rows, [&](const ViewModeRow& one) { return one.fits(parts.client.options); });
  return row->make(parts);  // the last row always fits
}

}  // namespace prosector
