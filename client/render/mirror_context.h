#pragma once
// A headset's view mirrored to a window on the desktop, or a context of the desktop's window system for the
// headset's frames.

#include <functional>
#include <memory>

#include "client/render/window_context.h"

namespace prosector {

enum class WindowSystem : std::uint8_t { egl, glx };  // the API that makes a window's context

/// OpenGL context for drawing a headset's frames, with an optional window on the desktop that shows one eye's
/// view to an audience.
class MirrorContext : public GlContext {
 public:
  /// Shows a frame of `width` × `height` pixels in the audience window; does nothing after a user closed the
  /// window. `copy` must copy the frame into the OpenGL texture that it is called with.
  virtual void show(int width, int height, const std::function<void(unsigned texture)>& copy) = 0;
  /// Processes the audience window's events; to be called while there is no frame to show.
  virtual void wait() = 0;
};

/// Creates a context by EGL or GLX for frames of `width` × `height` pixels, and opens the audience window, if
/// one is given. Throws InputError as make_window_context() and WindowContext::open_audience() do.
std::unique_ptr<MirrorContext> make_mirror_context(WindowSystem system, int width, int height,
                                                   const std::optional<Audience>& audience);

}  // namespace prosector
