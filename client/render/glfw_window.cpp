#include "client/render/glfw_window.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "common/error.h"

namespace prosector {
namespace {

std::string last_glfw_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description ? description : "no reason given";
}

}  // namespace

void start_glfw() {
  if (!glfwInit())
    throw InputError(
        fmt::format("cannot open a window: {}; run the program in a desktop session (DISPLAY), or choose an "
                    "offscreen display",
                    last_glfw_error()));
}

GLFWwindow* open_glfw_window(int width, int height, const std::string& title) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer has separate framebuffers
  GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (!window) {
    const std::string reason = last_glfw_error();
    glfwTerminate();
    throw InputError(
        fmt::format("cannot open a window with OpenGL 3.3 core: {}; update the graphics driver", reason));
  }
  glfwMakeContextCurrent(window);
  return window;
}

}  // namespace prosector
