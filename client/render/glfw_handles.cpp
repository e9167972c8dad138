#include "client/render/glfw_handles.h"

#include <EGL/egl.h>
#include <dlfcn.h>

#include <array>

#define GLFW_INCLUDE_NONE
#define GLFW_EXPOSE_NATIVE_EGL
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include "common/error.h"

namespace prosector {
namespace {

constexpr int glx_fbconfig_id = 0x8013, glx_screen = 0x800C, glx_visual_id = 0x800B;  // GLX 1.3

template <class Function>
Function find_glx(const char* name) {
  const auto found = reinterpret_cast<Function>(glfwGetProcAddress(name));
  if (found == nullptr)
    throw InputError("a window by GLX is not possible: GLX 1.3 is missing; install the graphics driver");
  return found;
}

/// Finds a GLFW function that exists only in builds for X11, unlike Debian's libglfw3-wayland.
template <class Function>
Function find_x11(const char* name) {
  void* const found = dlsym(RTLD_DEFAULT, name);
  if (found == nullptr)
    throw InputError("a window by GLX is not possible: GLFW was built without X11; install libglfw3");
  return reinterpret_cast<Function>(found);
}

}  // namespace

EglHandles egl_of(GLFWwindow* window) {
  const EGLDisplay display = glfwGetEGLDisplay();
  const EGLContext context = glfwGetEGLContext(window);
  EGLint id = 0, found = 0;
  EGLConfig config{};
  eglQueryContext(display, context, EGL_CONFIG_ID, &id);
  const EGLint wish[] = {EGL_CONFIG_ID, id, EGL_NONE};
  if (!eglChooseConfig(display, wish, &config, 1, &found) || found == 0)
    throw InputError(
        "a window by EGL is not possible: EGL does not find the configuration of the window's context");
  return {display, config, context};
}

GlxHandles glx_of(GLFWwindow* window) {
  void* const display = find_x11<void* (*)()>("glfwGetX11Display")();
  void* const context = find_x11<void* (*)(GLFWwindow*)>("glfwGetGLXContext")(window);
  const auto query = find_glx<int (*)(void*, void*, int, int*)>("glXQueryContext");
  const auto choose = find_glx<void** (*)(void*, int, const int*, int*)>("glXChooseFBConfig");
  const auto attribute = find_glx<int (*)(void*, void*, int, int*)>("glXGetFBConfigAttrib");
  int id = 0, screen = 0, found = 0, visual = 0;
  query(display, context, glx_fbconfig_id, &id);
  query(display, context, glx_screen, &screen);
  const std::array<int, 3> wish = {glx_fbconfig_id, id, 0};
  void** const configs = choose(display, screen, wish.data(), &found);  // owned by X11; never freed
  if (configs == nullptr || found == 0)
    throw InputError(
        "a window by GLX is not possible: GLX does not find the configuration of the window's context");
  attribute(display, configs[0], glx_visual_id, &visual);
  const auto drawable = find_x11<unsigned long (*)(GLFWwindow*)>("glfwGetGLXWindow")(window);
  return {display, static_cast<unsigned long>(visual), configs[0], drawable, context};
}

}  // namespace prosector
