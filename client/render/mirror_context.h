#pragma once
// A headset's view mirrored to a window on the desktop, or a context of the desktop's window system for the
// headset's frames.

#include <functional>
#include <memory>

#include "client/render/window_context.h"

namespace prosector {

enum class WindowSystem : std::uint8_t { egl, glx };  // the API that makes a window's context

/// A context for drawing a headset's frames, with an optional audience window that shows one eye's view.
class MirrorContext : public GlContext {
 public:
  /// Shows the frame of the given size, which `copy` copies into the texture, until a user closes the window.
  virtual void show(int width, int height, const std::function<void(unsigned texture)>& copy) = 0;
  /// Processes the window's events while there is no frame to show.
  virtual void wait() = 0;
};

/// Makes the context with the given size, and opens the audience window, if any. Throws InputError as
/// make_window_context() and WindowContext::open_audience() do.
std::unique_ptr<MirrorContext> make_mirror_context(WindowSystem system, int width, int height,
                                                   const std::optional<Audience>& audience);

}  // namespace prosector
