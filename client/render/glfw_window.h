#pragma once
// A GLFW window with OpenGL 3.3 core. Private to client/render.

#include <string>

struct GLFWwindow;

namespace prosector {

/// Initialises GLFW. Throws InputError without a display. The caller calls glfwTerminate().
void start_glfw();
/// Opens a window with the current GLFW hints, and makes its context current. Without OpenGL 3.3, terminates
/// GLFW and throws InputError.
GLFWwindow* open_glfw_window(int width, int height, const std::string& title);

}  // namespace prosector
