#include "client/render/mirror_context.h"

#include <EGL/egl.h>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_EGL
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include "client/render/audience_window.h"
#include "client/render/glfw_window.h"
#include "common/error.h"

namespace prosector {
namespace {

/// Returns the configuration that the context was made with, which GLFW doesn't tell.
EGLConfig config_of(EGLDisplay display, EGLContext context) {
  EGLint id = 0, found = 0;
  EGLConfig out{};
  eglQueryContext(display, context, EGL_CONFIG_ID, &id);
  const EGLint wish[] = {EGL_CONFIG_ID, id, EGL_NONE};
  if (!eglChooseConfig(display, wish, &out, 1, &found) || found == 0)
    throw InputError("--audience: EGL doesn't know the window's configuration");
  return out;
}

/// GLFW shares a context among windows alone. So pictures are drawn in that of a window which nobody sees.
class GlfwMirror final : public MirrorContext {
 public:
  GlfwMirror(int width, int height, const Audience& audience) : width_(width), height_(height) {
    check_picture_size(width, height);
    start_glfw();
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = open_glfw_window(width, height, "Prosector");
    glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
    try {
      const EGLDisplay display = glfwGetEGLDisplay();
      const EGLContext context = glfwGetEGLContext(window_);
      egl_ = {display, config_of(display, context), context};
      audience_ = std::make_unique<AudienceWindow>(window_, *this, audience);
    } catch (...) {
      glfwTerminate();
      throw;
    }
  }
  ~GlfwMirror() override {
    audience_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  GlfwMirror(const GlfwMirror&) = delete;
  GlfwMirror& operator=(const GlfwMirror&) = delete;

  void* proc(const char* name) const override { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return false; }
  void present() override {}
  std::optional<EglHandles> egl() const override { return egl_; }
  std::string description() const override { return describe_gl(*this, "EGL with a window"); }

  void show(int width, int height, const std::function<void(unsigned texture)>& copy) override {
    wait();
    if (audience_) audience_->show(width, height, copy);
  }
  void wait() override {
    glfwPollEvents();
    if (audience_ && audience_->closed()) audience_.reset();
  }

 private:
  int width_, height_;
  GLFWwindow* window_ = nullptr;
  EglHandles egl_{};
  std::unique_ptr<AudienceWindow> audience_;
};

}  // namespace

std::unique_ptr<MirrorContext> make_mirror_context(int width, int height, const Audience& audience) {
  return std::make_unique<GlfwMirror>(width, height, audience);
}

}  // namespace prosector
