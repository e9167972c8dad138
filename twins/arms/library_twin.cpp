#include "twins/arms/library_twin.h"

#include <bit>
#include <cstdlib>
#include <iostream>

#include "common/clock.h"

namespace prosector {
namespace {

constexpr const char* words_variable = "PROSECTOR_TWIN";

/// Reads the settings from the environment. Returns nothing if they are missing or invalid, and reports it on
/// standard error.
std::optional<ArmTwinSettings> settings_in_environment() {
  const char* words = std::getenv(words_variable);
  if (words == nullptr) {
    std::cerr
        << "simulated arm: " << words_variable
        << " must contain the options of the simulated arm, at least the hand's script: --script FILE\n";
    return std::nullopt;
  }
  CLI::App app("", words_variable);
  ArmTwinSettings settings;
  add_arm_options(app, settings, "numbers");
  app.add_flag("--turns", settings.turns,
               "The motors also apply torques to the stylus, as in some arms of Force Dimension");
  try {
    app.parse(words, false);
  } catch (const CLI::ParseError& error) {
    app.exit(error);
    return std::nullopt;
  }
  return settings;
}

}  // namespace

void LibraryTwin::restart(HeldArmOptions options, std::int64_t now_ns, std::uint64_t seed) {
  tested_ = true;
  now_ns_ = now_ns;
  faults = {};
  random_.seed(seed);
  arm_.emplace(std::move(options), mechanics_, now_ns);
  if (on_restart) on_restart();
}

void LibraryTwin::advance(std::int64_t now_ns) {
  now_ns_ = now_ns;
  if (HeldArm* held = arm()) {
    held->advance(now_ns);
    if (log_ && held->taken()) log_->write(now_ns, *held);
  }
  if (on_tick) on_tick();
}

HeldArm* LibraryTwin::arm() {
  if (arm_ || tested_) return arm_ ? &*arm_ : nullptr;
  try {
    const auto settings = settings_in_environment();
    if (!settings) return nullptr;
    arm_.emplace(held_arm_options(*settings), mechanics_, monotonic_ns());
    log_.emplace(settings->log);
    faults.garbage = settings->garbage;
    random_.seed(settings->seed);
  } catch (const std::exception& error) {
    std::cerr << "simulated arm: " << error.what() << "\n";
    return nullptr;
  }
  return &*arm_;
}

double LibraryTwin::reported(double value) {
  if (faults.instead) return *faults.instead;
  if (faults.garbage <= 0 || std::uniform_real_distribution<double>(0, 1)(random_) >= faults.garbage)
    return value;
  return std::bit_cast<double>(random_());
}

}  // namespace prosector
