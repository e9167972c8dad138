#pragma once
// Common core of simulated arms that are vendor libraries: mechanics in a hand, faults for tests, and time.
// In a client it reads its options from the environment variable PROSECTOR_TWIN, as other simulated arms do
// from the command line ("--script press.csv --log /tmp/arm.csv"). In a test, the test advances its time.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <random>

#include "twins/arms/arm_twin_program.h"
#include "twins/arms/held_arm.h"

namespace prosector {

/// Simulated faults and state of the device.
struct LibraryFaults {
  bool away = false;               // no device is found; an open device returns errors
  int version = 3;                 // major version of the library
  int error = 0;                   // result of each call, in the library's error codes; 0: none
  int force_error = 0;             // result of each force command, in the library's error codes; 0: none
  std::optional<double> instead;   // replaces each reported number
  double garbage = 0;              // fraction of reported numbers that are random bits
  double temperature = 0.2;        // of the motors, 0 … 1
  bool needs_calibration = false;  // the device lost its calibration
  bool forces_off = false;         // the user released its force switch
  bool gripper = false;            // the device has a gripper instead of buttons
  std::uint32_t buttons = 0;
};

class LibraryTwin {
 public:
  explicit LibraryTwin(const ArmMechanics& mechanics) : mechanics_(mechanics) {}

  /// Restarts the twin with simulated time, which the test advances with advance().
  void restart(HeldArmOptions options, std::int64_t now_ns, std::uint64_t seed);
  /// Advances the arm to `now_ns`, then calls `on_tick`.
  void advance(std::int64_t now_ns);
  std::int64_t now_ns() const { return now_ns_; }
  bool has_own_clock() const { return !tested_; }
  /// Returns the arm; nullptr if no script defines its hand's motion.
  HeldArm* arm();

  /// Returns a number as the library reports it, with the simulated faults.
  double reported(double value);

  LibraryFaults faults;
  std::recursive_mutex mutex;  // guards all of it: in a client several threads call the library
  std::function<void()> on_restart, on_tick;

 private:
  ArmMechanics mechanics_;
  bool tested_ = false;
  std::int64_t now_ns_ = 0;
  std::optional<HeldArm> arm_;
  std::optional<ArmLog> log_;
  std::mt19937_64 random_;
};

/// Executes a function of the library under its lock. `Twin` has a LibraryTwin `library`.
template <class Twin, class Does>
auto locked(Twin& twin, Does does) {
  const std::lock_guard lock(twin.library.mutex);
  return does(twin);
}

/// Name of the function with which a test accesses the twin in a library: LibraryTwin* (*)().
inline constexpr const char* twin_function = "prosector_twin";

}  // namespace prosector
