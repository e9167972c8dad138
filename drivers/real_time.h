#pragma once
// Priorities of the threads in an arm's loop.

namespace prosector {

// SCHED_FIFO's numbers, above the desktop's sound and below the kernel's interrupts: the servo's, and that of
// the thread that talks to an arm for it.
inline constexpr int servo_priority = 50, line_priority = 49;

/// Asks for a real-time priority for the thread that calls. Returns whether the system gave it.
bool ask_for_real_time(int priority);

}  // namespace prosector
