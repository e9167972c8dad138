#pragma once
// Arms at real sockets of their twins, in real time; whatever is waited for is bounded.

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

#include "drivers/device/arm.h"
#include "tests/haptics/press_case.h"

namespace prosector {

/// Does something about a thousand times a second, on a thread of its own, as long as it is there.
class EachMillisecond {
 public:
  explicit EachMillisecond(std::function<void()> does)
      : thread_([does = std::move(does)](const std::stop_token& stop) {
          for (; !stop.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(1))) does();
        }) {}

 private:
  std::jthread thread_;
};

/// Waits until it holds. Returns false when that takes longer than it does on however busy a machine.
inline bool comes_true(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  for (; std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(std::chrono::milliseconds(1)))
    if (holds()) return true;
  return false;
}

/// Reads the arm and pushes with 1 N, as a servo does, until a reading is as wanted. Returns as comes_true().
inline bool comes(Arm& arm, const std::function<bool(const ArmReading&)>& holds) {
  return comes_true([&] {
    const ArmReading reading = arm.read();
    arm.set_force({0, 1, 0});
    return holds(reading);
  });
}

inline bool valid(const ArmReading& reading) {
  return reading.valid;
}

}  // namespace prosector
