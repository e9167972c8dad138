#pragma once
// The thread that moves an arm: reads it, computes a force, sends it, a thousand times a second. It never
// waits for the network or for who looks at it.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "client/haptics/haptic_loop.h"
#include "drivers/arm.h"

namespace prosector {

/// How late cycles begin, s.
struct Lateness {
  std::uint64_t cycles = 0, skipped = 0;  // skipped: a whole period too late, and never caught up
  double p50 = 0, p99 = 0, worst = 0;
};

/// What the thread has to show.
struct ServoView {
  ArmReading reading;             // the hand that the stylus moves, in the room
  Vec3 force = Vec3::Zero();      // N, on the person's hand, mean since the last view
  Vec3 force_now = Vec3::Zero();  // N, of the last cycle
  EnergyBook energy;
  GuardCounts guard;
  DeviceStatus status;
};

class ServoThread {
 public:
  /// Starts. `hand_of_stylus`: pose of the hand in the stylus' frame. `dead_man`: bits of buttons of which
  /// one must be down for any force to act; 0: none must. Tries to run with a real-time priority.
  ServoThread(std::unique_ptr<Arm> arm, const Pose& hand_of_stylus, std::uint32_t dead_man = 0);
  ~ServoThread();

  /// Passes on what the hand feels now. Called by the network's thread.
  void feel(std::vector<ContactPlane> planes);
  /// Passes on that the last of them were told again.
  void heard_again() { repeated_ = true; }
  ServoView view();
  Lateness lateness() const;
  /// Tells whether the system gave it a real-time priority.
  bool real_time() const { return real_time_; }

 private:
  void run(std::stop_token stop);
  void cycle(double time);
  void count_lateness(std::int64_t late_ns);

  std::unique_ptr<Arm> arm_;
  Pose hand_of_stylus_;
  std::uint32_t dead_man_;
  HapticLoop loop_;
  std::atomic<bool> real_time_ = false, repeated_ = false;

  mutable std::mutex mutex_;  // of what follows; the servo takes it only if it is free, but when it shows
  std::optional<std::vector<ContactPlane>> planes_;
  ServoView view_;
  Vec3 force_sum_ = Vec3::Zero();
  std::uint64_t forces_ = 0;

  // By lateness: eight bins an octave, from a microsecond on.
  std::array<std::atomic<std::uint64_t>, 8 * 16> late_{};
  std::atomic<std::uint64_t> cycles_ = 0, skipped_ = 0;
  std::atomic<std::int64_t> worst_ns_ = 0;
  std::jthread thread_;  // last: it ends before what it uses
};

}  // namespace prosector
