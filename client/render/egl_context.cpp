// EGL without a window system: EGL_MESA_platform_surfaceless, OpenGL through eglGetProcAddress.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "client/render/gl_context.h"
#include "common/error.h"

namespace prosector {
namespace {

[[noreturn]] void fail(const char* what) {
  throw InputError(
      fmt::format("cannot render offscreen with EGL: {} (error 0x{:x}); install libegl1 and libgl1-mesa-dri, "
                  "or use OSMesa (libosmesa6)",
                  what, eglGetError()));
}

class EglContext final : public GlContext {
 public:
  EglContext(int width, int height) : width_(width), height_(height) {
    check_picture_size(width, height);
    const auto get_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!get_display) fail("no eglGetPlatformDisplayEXT");
    display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) fail("no display");
    if (!eglBindAPI(EGL_OPENGL_API)) fail("no desktop OpenGL");
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
    EGLint found = 0;
    if (!eglChooseConfig(display_, config_attributes, &config_, 1, &found) || found == 0)
      fail("no configuration");
    const EGLint wish[] = {EGL_CONTEXT_MAJOR_VERSION,
                           3,
                           EGL_CONTEXT_MINOR_VERSION,
                           3,
                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                           EGL_NONE};
    context_ = eglCreateContext(display_, config_, EGL_NO_CONTEXT, wish);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 3.3 core context");
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
      eglDestroyContext(display_, context_);
      fail("the OpenGL context cannot be made current");
    }
  }
  ~EglContext() override {
    // The display is shared by all contexts of this process, so it is not terminated.
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void* proc(const char* name) const override { return reinterpret_cast<void*>(eglGetProcAddress(name)); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return false; }
  void present() override {}
  ContextHandles handles() const override { return EglHandles{display_, config_, context_}; }
  std::string description() const override { return describe_gl(*this, "EGL surfaceless"); }

 private:
  int width_, height_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLConfig config_{};
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<GlContext> make_egl_context(int width, int height) {
  return std::make_unique<EglContext>(width, height);
}

}  // namespace prosector
