#pragma once
// Objects that a client needs for rendering: scene view, view mode, renderer.

#include <memory>

#include "client/app/run/view_mode_factory.h"
#include "client/render/renderer.h"

namespace prosector {

struct Stage {
  SceneView scene;
  std::unique_ptr<ViewMode> mode;
  std::unique_ptr<Renderer> renderer;  // in the mode's context
};

/// Creates the objects that render the session; null with --display none. The arguments must outlive them. A
/// headset passes its wearer's poses to `user`. `camera`: shared by trackers, eye tracking and --display ar;
/// null: none. Throws InputError if OpenGL or the display is unavailable.
std::unique_ptr<Stage> make_stage(ViewerContext& client, HeadsetUser& user,
                                  const std::shared_ptr<SharedCamera>& camera);

}  // namespace prosector
