#pragma once
// Servo thread of an arm: reads it, computes a force and sends it a thousand times a second. It never waits
// for the network or for threads that read its state.

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "client/haptics/haptic_loop.h"
#include "drivers/device/arm.h"

namespace prosector {

/// Delays of the servo cycles' starts after their deadlines, s: median, 99th percentile and maximum, with the
/// numbers of cycles.
struct Lateness {
  std::uint64_t cycles = 0, skipped = 0;  // skipped: more than a period late, and not made up
  double p50 = 0, p99 = 0, worst = 0;
};

/// State of a haptic arm and its servo loop, copied for other threads: pose, forces, energy balance, numbers
/// of interventions of the safety limits, and the device's status.
struct ServoView {
  ArmReading reading;             // pose of the hand attached to the stylus, room frame
  Vec3 force = Vec3::Zero();      // N, on the user's hand, mean since the last view()
  Vec3 force_now = Vec3::Zero();  // N, of the last cycle
  EnergyBook energy;
  GuardCounts guard;
  DeviceStatus status;
};

class ServoThread {
 public:
  /// Starts the thread, with a real-time priority if the system grants it. `hand_of_stylus`: pose of the hand
  /// in the stylus frame. `dead_man`: bit mask of buttons; forces act only while one of them is pressed; 0:
  /// forces act without a button.
  ServoThread(std::unique_ptr<Arm> arm, const Pose& hand_of_stylus, std::uint32_t dead_man = 0);
  ~ServoThread();

  /// Passes the newest contact planes (local linear models of the contact forces) to the servo thread. Called
  /// on the network thread.
  void feel(std::vector<ContactPlane> planes);
  /// Notifies the servo thread that the newest contact planes were received again, unchanged, so that the
  /// connection counts as alive.
  void repeat_received() { repeated_ = true; }
  ServoView view();
  Lateness lateness() const;
  /// Returns whether the system granted the servo thread a real-time priority.
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

  mutable std::mutex mutex_;  // guards planes_ … forces_; the servo only tries to lock it and never waits
  std::optional<std::vector<ContactPlane>> planes_;
  ServoView view_;
  Vec3 force_sum_ = Vec3::Zero();
  std::uint64_t forces_ = 0;

  // Histogram of the delays: eight bins an octave, from 1 µs on.
  std::array<std::atomic<std::uint64_t>, 8 * 16> late_{};
  std::atomic<std::uint64_t> cycles_ = 0, skipped_ = 0;
  std::atomic<std::int64_t> worst_ns_ = 0;
  std::jthread thread_;  // declared last: it ends before the members that it uses
};

}  // namespace prosector
