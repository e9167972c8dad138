#pragma once
// Chooses the view mode by the client's options.

#include <memory>

#include "client/app/run/view_mode.h"
#include "client/app/user/headset_user.h"
#include "client/view/scene_view.h"
#include "drivers/camera/devices/shared_camera.h"

namespace prosector {

/// Objects that a view mode (desktop window, headset, camera image or offscreen) uses. All must outlive the
/// mode.
struct ViewModeParts {
  ViewerContext& client;
  SceneView& scene;
  HeadsetUser& headset_user;                   // receives a headset user's poses
  const std::shared_ptr<SharedCamera> camera;  // for augmented reality or eye tracking; null: none
};

/// Creates the view mode that the client's options select: desktop window, headset, camera image or
/// offscreen. The options must name a display. Throws InputError if OpenGL or a device is unavailable.
std::unique_ptr<ViewMode> make_view_mode(const ViewModeParts& parts);

}  // namespace prosector
