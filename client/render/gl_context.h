#pragma once
// Sources of an OpenGL 3.3 core context: EGL surfaceless, OSMesa, or a window. The renderer works with each
// of them.

#include <memory>
#include <string>
#include <variant>

namespace prosector {

/// Handles of an EGL context, for libraries that share it: EGLDisplay, EGLConfig, EGLContext.
struct EglHandles {
  void *display, *config, *context;
};
/// Handles of a GLX context: Display*, VisualID, GLXFBConfig, GLXDrawable, GLXContext.
struct GlxHandles {
  void* display;
  unsigned long visual;
  void* config;
  unsigned long drawable;
  void* context;
};
/// Handles of a context; monostate: it cannot be shared.
using ContextHandles = std::variant<std::monostate, EglHandles, GlxHandles>;

/// A current context. Not thread safe: used by the thread that made it, one context per thread at a time.
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

/// Makes a context. Throws InputError that states what is missing and what to install or set.
std::unique_ptr<GlContext> make_egl_context(int width, int height);
std::unique_ptr<GlContext> make_osmesa_context(int width, int height);
/// Makes an EGL surfaceless context, or an OSMesa context if that fails.
std::unique_ptr<GlContext> make_offscreen_context(int width, int height);

inline constexpr int max_picture_size = 8192;  // pixels, width and height

/// Throws InputError unless 1 ≤ width, height ≤ max_picture_size.
void check_picture_size(int width, int height);
/// Returns "KIND, renderer, version" of the current context.
std::string describe_gl(const GlContext& context, const std::string& kind);

}  // namespace prosector
