#pragma once
// `prosector-client record`: records a device's samples to a file that the drivers `recorded` and
// `recorded-loop` play.

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace prosector {

struct RecordOptions {
  std::string address;           // DRIVER:PATH, or a table of the configuration
  std::filesystem::path out;     // CSV file
  std::filesystem::path config;  // configuration of the device; empty: defaults
  double seconds = 0;            // 0: until interrupted
};

/// Adds the options of the command.
void add_record(CLI::App& command, RecordOptions& options);

/// Records until the time is over or a SIGINT or SIGTERM arrives. Returns the exit code.
int record_device(const RecordOptions& options);

}  // namespace prosector
