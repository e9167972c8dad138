#pragma once
// Options, log and main loop shared by the programs and libraries that simulate an arm.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "twins/arms/held_arm.h"

namespace prosector {

struct ArmTwinSettings {
  std::string script, log, hand = "medium";
  std::vector<double> room = {0, 0, 0, 1, 0, 0, 0};
  TwinTiming timing;
  double garbage = 0;
  bool turns = false;
  std::uint64_t seed = 1;
};

/// Adds the options shared by all simulated arms. `garbage` names the data that may be random bytes
/// ("packets").
void add_arm_options(CLI::App& app, ArmTwinSettings& settings, const char* garbage);
/// Converts the settings to options of the arm. Throws InputError if the script is unreadable.
HeldArmOptions held_arm_options(const ArmTwinSettings& settings);

/// CSV log of the arm's position, motor force, the hand's target and the energy of the motors.
class ArmLog {
 public:
  /// Creates the file; with an empty name nothing is written. Throws InputError if it is not writable.
  explicit ArmLog(const std::string& file);
  void write(std::int64_t now_ns, const HeldArm& arm);

 private:
  std::ofstream out_;
};

/// Calls `cycle` 1000 times a second until SIGINT or SIGTERM. If the script has holds, each line on standard
/// input calls `go_on`.
void serve_arm(const ArmTwinSettings& settings, const std::function<void(std::int64_t now_ns)>& cycle,
               const std::function<void(std::int64_t now_ns)>& go_on);

}  // namespace prosector
