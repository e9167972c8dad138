#pragma once
// What a headset shows, in a window on the desk.

#include <functional>
#include <memory>

#include "client/render/window_context.h"

namespace prosector {

/// A context by EGL, in which a headset's pictures are drawn, with an audience's window that shows one eye's.
class MirrorContext : public GlContext {
 public:
  /// Shows the picture of that size, which `copy` copies into the texture, until somebody closes the window.
  virtual void show(int width, int height, const std::function<void(unsigned texture)>& copy) = 0;
  /// Takes the window's events while there is nothing to show.
  virtual void wait() = 0;
};

/// Makes the context, whose own size is that, and opens the window. Throws InputError as
/// make_window_context() and WindowContext::open_audience() do.
std::unique_ptr<MirrorContext> make_mirror_context(int width, int height, const Audience& audience);

}  // namespace prosector
