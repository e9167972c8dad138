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

/// Faults and state of a simulated haptic device behind a vendor library, set by tests.
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

  /// Restarts the simulated device with the given motion and with simulated time, which the test advances
  /// with advance(). `seed` determines its random faults.
  void restart(HeldArmOptions options, std::int64_t now_ns, std::uint64_t seed);
  /// Advances the simulated arm to the time `now_ns`, then calls `on_tick`.
  void advance(std::int64_t now_ns);
  std::int64_t now_ns() const { return now_ns_; }
  bool has_own_clock() const { return !tested_; }
  /// Returns the simulated arm. In a client, the first call creates it from the options in the environment
  /// variable PROSECTOR_TWIN; the result is nullptr if they are missing or invalid. In a test, the result is
  /// nullptr before restart().
  HeldArm* arm();

  /// Returns a number as the simulated library reports it: unchanged, or replaced by a fault that the test
  /// has set, such as random bits.
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

/// Calls `does` with the simulated device `twin` while its lock is held, and returns the result. Each
/// function of the simulated library does so. `Twin` has a LibraryTwin `library`.
template <class Twin, class Does>
auto locked(Twin& twin, Does does) {
  const std::lock_guard lock(twin.library.mutex);
  return does(twin);
}

/// Name of the function in a simulated vendor library with which a test accesses the simulated device. Its
/// type is LibraryTwin* (*)().
inline constexpr const char* twin_function = "prosector_twin";

}  // namespace prosector
