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

/// Adds the command-line options of `prosector-client record` to `command`. Parsing stores their values in
/// `options`, which must outlive it.
void add_record(CLI::App& command, RecordOptions& options);

/// Records a device's samples to a CSV file until the time is over or SIGINT or SIGTERM arrives. Returns the
/// program's exit code.
int record_device(const RecordOptions& options);

}  // namespace prosector
