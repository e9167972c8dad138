#pragma once
// Monitors by number. Private to client/render.

struct GLFWmonitor;

namespace prosector {

/// Returns a monitor by number; 0 is the desktop's primary monitor. Throws InputError with the number of
/// monitors if there is none with this number.
GLFWmonitor* glfw_monitor(int number);

}  // namespace prosector
