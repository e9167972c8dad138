#pragma once
// Sources of an OpenGL 3.3 core context: EGL surfaceless, OSMesa, or a window. The renderer works with each
// of them.

#include <memory>
#include <string>
#include <variant>

namespace prosector {

/// Handles of an EGL context for libraries that share the context, such as OpenXR: an EGLDisplay, an
/// EGLConfig and an EGLContext.
struct EglHandles {
  void *display, *config, *context;
};
/// Handles of a GLX context for libraries that share the context, such as OpenXR: a Display*, a VisualID, a
/// GLXFBConfig, a GLXDrawable and a GLXContext.
struct GlxHandles {
  void* display;
  unsigned long visual;
  void* config;
  unsigned long drawable;
  void* context;
};
/// Handles of an OpenGL context for libraries that share it; monostate if the context cannot be shared.
using ContextHandles = std::variant<std::monostate, EglHandles, GlxHandles>;

/// OpenGL 3.3 core context, which is current from its creation on. Not thread safe: it is used by the thread
/// that created it, and a thread has at most one context at a time.
class GlContext {
 public:
  virtual ~GlContext() = default;
  virtual void* proc(const char* name) const = 0;  // address of a GL function
  virtual int width() const = 0;                   // of the frame, pixels
  virtual int height() const = 0;
  virtual bool has_screen() const = 0;  // framebuffer 0 belongs to a window; false offscreen
  virtual void present() = 0;           // swaps a window's buffers; does nothing offscreen
  virtual ContextHandles handles() const { return {}; }
  virtual std::string description() const = 0;  // "EGL surfaceless, llvmpipe (…), Mesa 22.3.6"
};

/// Creates an EGL context without a window, for frames of this size (pixels), and makes it current;
/// make_osmesa_context() creates one of OSMesa (software rendering). Both throw InputError that states what
/// is missing and what to install or set.
std::unique_ptr<GlContext> make_egl_context(int width, int height);
std::unique_ptr<GlContext> make_osmesa_context(int width, int height);
/// Creates an EGL context without a window, or an OSMesa context (software rendering) if that fails. `width`
/// and `height` are the frame's, in pixels.
std::unique_ptr<GlContext> make_offscreen_context(int width, int height);

inline constexpr int max_picture_size = 8192;  // pixels, width and height

/// Throws InputError unless a frame's width and height are both from 1 to max_picture_size pixels.
void check_picture_size(int width, int height);
/// Returns a description of the current OpenGL context for users: "KIND, renderer, version", where KIND is
/// `kind`.
std::string describe_gl(const GlContext& context, const std::string& kind);

}  // namespace prosector
