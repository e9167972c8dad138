#pragma once
// Options and main function shared by the programs of simulated devices.

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/recordings/motion_script.h"
#include "twins/base/twin_server.h"

namespace prosector {

struct TwinProgramOptions {
  std::string script;
  TwinTiming timing;
  TwinServerOptions server;
  std::vector<double> silence, unplug, babble;
  std::uint64_t seed = 1;
  std::string address;  // printed before the path in the line that reports the twin's address
};

/// Converts the two numbers (s) of a command-line option FROM,TO to a time span. Returns nothing if the
/// option is not given.
std::optional<FaultSpan> from_to(const std::vector<double>& numbers);

/// Adds the command-line options that all simulated devices share, including --version with the name of
/// `app`. `options` receives their values.
void add_options(CLI::App& app, TwinProgramOptions& options);

/// Parses the command line of a simulated device. Returns the exit status if the program should end: 2 for
/// invalid options, 0 after help. Returns nothing if the program should run.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Creates the simulated device with `make` and serves clients until SIGINT or SIGTERM. Returns the exit
/// status: 0, or 2 after an input error, which is printed on standard error.
int run_twin(TwinProgramOptions& options,
             const std::function<std::unique_ptr<Twin>(MotionScript, std::int64_t now_ns)>& make);

}  // namespace prosector
