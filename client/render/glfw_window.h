#pragma once
// A window of GLFW with OpenGL 3.3 core. Private to client/render.

#include <string>

struct GLFWwindow;

namespace prosector {

/// Starts GLFW. Throws InputError where there is no display. glfwTerminate() ends it.
void start_glfw();
/// Opens a window by the hints that are set, and makes its context current. Throws InputError, with GLFW
/// ended, where there is no OpenGL 3.3.
GLFWwindow* open_glfw_window(int width, int height, const std::string& title);

}  // namespace prosector
