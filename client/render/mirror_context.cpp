#include "client/render/mirror_context.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "client/render/audience_window.h"
#include "client/render/glfw_handles.h"
#include "client/render/glfw_window.h"

namespace prosector {
namespace {

/// GLFW shares contexts only between windows, so the frames are drawn in the context of a hidden window.
class GlfwMirror final : public MirrorContext {
 public:
  GlfwMirror(WindowSystem system, int width, int height, const std::optional<Audience>& audience)
      : system_(system), width_(width), height_(height) {
    check_picture_size(width, height);
    start_glfw();
    glfwWindowHint(GLFW_CONTEXT_CREATION_API,
                   system == WindowSystem::egl ? GLFW_EGL_CONTEXT_API : GLFW_NATIVE_CONTEXT_API);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = open_glfw_window(width, height, "Prosector");
    glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
    try {
      handles_ =
          system == WindowSystem::egl ? ContextHandles(egl_of(window_)) : ContextHandles(glx_of(window_));
      if (audience) audience_ = std::make_unique<AudienceWindow>(window_, *this, *audience);
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
  ContextHandles handles() const override { return handles_; }
  std::string description() const override {
    return describe_gl(*this, system_ == WindowSystem::egl ? "EGL with a window" : "GLX with a window");
  }

  void show(int width, int height, const std::function<void(unsigned texture)>& copy) override {
    wait();
    if (audience_) audience_->show(width, height, copy);
  }
  void wait() override {
    glfwPollEvents();
    if (audience_ && audience_->closed()) audience_.reset();
  }

 private:
  WindowSystem system_;
  int width_, height_;
  GLFWwindow* window_ = nullptr;
  ContextHandles handles_;
  std::unique_ptr<AudienceWindow> audience_;
};

}  // namespace

std::unique_ptr<MirrorContext> make_mirror_context(WindowSystem system, int width, int height,
                                                   const std::optional<Audience>& audience) {
  return std::make_unique<GlfwMirror>(system, width, height, audience);
}

}  // namespace prosector
