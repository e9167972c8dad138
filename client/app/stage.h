#pragma once
// Everything that a client draws with.

#include <memory>

#include "client/app/desk.h"
#include "client/app/eye_window.h"
#include "client/app/headset_user.h"
#include "client/app/options.h"
#include "client/ar/camera_sight.h"
#include "client/render/mirror_context.h"
#include "client/render/renderer.h"
#include "client/render/window_context.h"
#include "client/view/scene_view.h"
#include "client/xr/headset.h"

namespace prosector {

struct Stage {
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;
  WindowContext* window = nullptr;      // the context, where it is one
  MirrorContext* mirror = nullptr;      // the context, where it is one: of a headset that others watch
  std::unique_ptr<Desk> desk;           // with a window only
  std::unique_ptr<Headset> headset;     // with --display openxr only
  std::unique_ptr<CameraSight> sight;   // with --display ar only
  std::unique_ptr<EyeWindow> eyes;      // where the screen is a window only
  std::optional<FoundPhantom> phantom;  // that was calibrated, before a camera only
  SceneView view;
};

/// Makes the stage; null with --display none. A headset tells `user`, who outlives it, where its wearer is.
/// `camera` is what others see by, too, and what --display ar looks through; null: there is none. Throws
/// InputError where OpenGL or the display refuses.
std::unique_ptr<Stage> make_stage(const ClientOptions& options, HeadsetUser& user,
                                  const std::shared_ptr<SharedCamera>& camera);

}  // namespace prosector
