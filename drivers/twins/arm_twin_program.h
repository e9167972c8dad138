#pragma once
// What the programs and libraries that play an arm share: their options, their log, their life.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include "drivers/twins/held_arm.h"

namespace prosector {

struct ArmTwinSettings {
  std::string script, log, hand = "medium";
  std::vector<double> room = {0, 0, 0, 1, 0, 0, 0};
  TwinTiming timing;
  double garbage = 0;
  bool turns = false;
  std::uint64_t seed = 1;
};

/// Adds the options that all simulated arms have. `garbage`: what of it may be random bytes ("packets").
void add_arm_options(CLI::App& app, ArmTwinSettings& settings, const char* garbage);
/// Returns what they say of the arm. Throws InputError for a script that can't be read.
HeldArmOptions held_arm_options(const ArmTwinSettings& settings);

/// The CSV of where an arm is, what its motors do, what the hand wants, and the energy that it gave.
class ArmLog {
 public:
  /// Begins the file; with an empty name nothing is written. Throws InputError where it can't be.
  explicit ArmLog(const std::string& file);
  void write(std::int64_t now_ns, const HeldArm& arm);

 private:
  std::ofstream out_;
};

/// Calls `cycle` a thousand times a second until SIGINT or SIGTERM. Where the script has holds, each line on
/// standard input calls `go_on`.
void serve_arm(const ArmTwinSettings& settings, const std::function<void(std::int64_t now_ns)>& cycle,
               const std::function<void(std::int64_t now_ns)>& go_on);

}  // namespace prosector
