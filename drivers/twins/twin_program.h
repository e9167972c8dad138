#pragma once
// What programs of simulated devices share: their options and their life.

#include <CLI/CLI.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/motion_script.h"
#include "drivers/twins/twin_server.h"

namespace prosector {

struct TwinProgramOptions {
  std::string script;
  TwinTiming timing;
  TwinServerOptions server;
  std::vector<double> silence, unplug, babble;
  std::uint64_t seed = 1;
  std::string address;  // what comes before the path in the line that says where it is
};

/// Returns the span of an option FROM,TO; nothing where it isn't given.
std::optional<FaultSpan> from_to(const std::vector<double>& numbers);

/// Adds the options that all have, --version with the name of `app` included.
void add_options(CLI::App& app, TwinProgramOptions& options);

/// Reads the command line. Returns the exit status where there is nothing more to do: bad options are 2, help
/// 0.
std::optional<int> parse(CLI::App& app, int argc, char** argv);

/// Makes the twin and serves it until SIGINT or SIGTERM. Returns the exit status. Bad input goes to stderr.
int run_twin(TwinProgramOptions& options,
             const std::function<std::unique_ptr<Twin>(MotionScript, std::int64_t now_ns)>& make);

}  // namespace prosector
