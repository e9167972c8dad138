#pragma once
// What a simulated arm that is a library has, whatever its functions are called: mechanics in a hand, faults
// that tests ask for, and time. In a client it follows the words in the environment's PROSECTOR_TWIN, the
// options of any simulated arm ("--script press.csv --log /tmp/arm.csv"); in a test the test gives the time.

#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <random>

#include "drivers/twins/arm_twin_program.h"
#include "drivers/twins/held_arm.h"

namespace prosector {

/// What is wrong with it.
struct LibraryFaults {
  bool away = false;               // no device is found; one that was open answers with errors
  int version = 3;                 // major one of the library
  int error = 0;                   // of each call, in the library's numbers; 0: none
  int force_error = 0;             // of each force, as that
  std::optional<double> instead;   // of each number told
  double garbage = 0;              // share of numbers told that are random bits
  double temperature = 0.2;        // of its motors, 0 … 1
  bool needs_calibration = false;  // it lost where it is: set once
  bool forces_off = false;         // somebody let go of its switch
  bool gripper = false;            // instead of buttons
  std::uint32_t buttons = 0;
};

class LibraryTwin {
 public:
  explicit LibraryTwin(const ArmMechanics& mechanics) : mechanics_(mechanics) {}

  /// Begins anew in the time of a test, which calls advance().
  void restart(HeldArmOptions options, std::int64_t now_ns, std::uint64_t seed);
  /// Goes on to that time, then calls `on_tick`.
  void advance(std::int64_t now_ns);
  std::int64_t now_ns() const { return now_ns_; }
  bool in_own_time() const { return !tested_; }
  /// Returns the arm; nullptr: nobody said what its hand does.
  HeldArm* arm();

  /// Returns a number as the library tells it, which is garbage where that is asked for.
  double told(double value);

  LibraryFaults faults;
  std::recursive_mutex mutex;  // of all of it: in a client several threads call the library
  std::function<void()> on_restart, on_tick;

 private:
  ArmMechanics mechanics_;
  bool tested_ = false;
  std::int64_t now_ns_ = 0;
  std::optional<HeldArm> arm_;
  std::optional<ArmLog> log_;
  std::mt19937_64 random_;
};

/// Does what a function of a library does, one thread at a time. `Twin` has a LibraryTwin `library`.
template <class Twin, class Does>
auto locked(Twin& twin, Does does) {
  const std::lock_guard lock(twin.library.mutex);
  return does(twin);
}

/// The function by which a test reaches the twin in a library: LibraryTwin* (*)().
inline constexpr const char* twin_function = "prosector_twin";

}  // namespace prosector
