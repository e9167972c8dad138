#pragma once
// Monitors by number. Private to client/render.

struct GLFWmonitor;

namespace prosector {

/// Returns the monitor with this number, counted from 0; 0 is the desktop's primary monitor. Throws
/// InputError that states the number of monitors if there is none with this number.
GLFWmonitor* glfw_monitor(int number);

}  // namespace prosector
