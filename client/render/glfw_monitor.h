#pragma once
// Monitors by number. Private to client/render.

struct GLFWmonitor;

namespace prosector {

/// Returns a monitor, counted from 0, the desktop's first. Throws InputError saying how many there are when
/// there is none of that number.
GLFWmonitor* glfw_monitor(int number);

}  // namespace prosector
