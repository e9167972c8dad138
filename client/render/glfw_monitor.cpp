#include "client/render/glfw_monitor.h"

#include <fmt/format.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "common/error.h"

namespace prosector {

GLFWmonitor* glfw_monitor(int number) {
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  if (number < 0 || number >= count)
    throw InputError(
        fmt::format("monitor {}: there {} {}, counted from 0", number, count == 1 ? "is" : "are", count));
  return monitors[number];
}

}  // namespace prosector
