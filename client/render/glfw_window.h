#pragma once
// A GLFW window with OpenGL 3.3 core. Private to client/render.

#include <string>

struct GLFWwindow;

namespace prosector {

/// Initialises the window library GLFW; the caller must call glfwTerminate() at the end. Throws InputError if
/// there is no display.
void start_glfw();
/// Opens a window with the current GLFW hints, and makes its OpenGL context current. If OpenGL 3.3 is
/// unavailable, terminates GLFW and throws InputError.
GLFWwindow* open_glfw_window(int width, int height, const std::string& title);

}  // namespace prosector
