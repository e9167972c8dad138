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

/// Adds the command-line options that all simulated arms share; `settings` receives their values. `garbage`
/// names the data that may be random bytes, such as "packets", in the help text.
void add_arm_options(CLI::App& app, ArmTwinSettings& settings, const char* garbage);
/// Converts the command-line settings of a simulated arm to options of its mechanics and script. Throws
/// InputError if the script is unreadable.
HeldArmOptions held_arm_options(const ArmTwinSettings& settings);

/// CSV log of a simulated arm: its position, the force of its motors, the position that the hand aims at, and
/// the energy of the motors.
class ArmLog {
 public:
  /// Creates the log's CSV file. With an empty name nothing is logged. Throws InputError if the file is not
  /// writable.
  explicit ArmLog(const std::string& file);
  void write(std::int64_t now_ns, const HeldArm& arm);

 private:
  std::ofstream out_;
};

/// Runs the main loop of a simulated arm: calls `cycle` 1000 times a second until SIGINT or SIGTERM. If the
/// motion script has holds (pauses), each line on standard input calls `go_on`, which ends the next hold.
void serve_arm(const ArmTwinSettings& settings, const std::function<void(std::int64_t now_ns)>& cycle,
               const std::function<void(std::int64_t now_ns)>& go_on);

}  // namespace prosector
