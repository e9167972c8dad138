#pragma once
// What a headset shows, in a window on the desk; or a context by the desk's window system for its pictures.

#include <functional>
#include <memory>

#include "client/render/window_context.h"

namespace prosector {

enum class WindowSystem : std::uint8_t { egl, glx };  // by which a window's context is made

/// A context in which a headset's pictures are drawn, with an audience's window that shows one eye's.
class MirrorContext : public GlContext {
 public:
  /// Shows the picture of that size, which `copy` copies into the texture, until somebody closes the window.
  virtual void show(int width, int height, const std::function<void(unsigned texture)>& copy) = 0;
  /// Takes the window's events while there is nothing to show.
  virtual void wait() = 0;
};

/// Makes the context, whose own size is that, and opens the audience's window, where there is an audience.
/// Throws InputError as make_window_context() and WindowContext::open_audience() do.
std::unique_ptr<MirrorContext> make_mirror_context(WindowSystem system, int width, int height,
                                                   const std::optional<Audience>& audience);

}  // namespace prosector
