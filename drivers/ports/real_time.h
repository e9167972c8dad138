#pragma once
// Thread priorities of an arm's control loop.

namespace prosector {

// SCHED_FIFO priorities of the servo thread and of the thread that communicates with an arm: above the
// desktop's sound, below the kernel's interrupts.
inline constexpr int servo_priority = 50, communication_priority = 49;

/// Requests the real-time scheduling policy SCHED_FIFO with this priority for the calling thread. Returns
/// whether the system granted it.
bool request_real_time_priority(int priority);

}  // namespace prosector
