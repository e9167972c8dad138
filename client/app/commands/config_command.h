#pragma once
// `prosector-client config`: checks a configuration, changes its keys, and migrates older versions.

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace prosector {

struct ConfigOptions {
  std::filesystem::path file;
  std::vector<std::string> changes;  // KEY=VALUE
  bool write = false;                // write to `file`; else print the result
  bool manual = false;               // print the reference page of all keys
};

/// Adds the command-line options of `prosector-client config` to `command`. Parsing stores their values in
/// `options`, which must outlive it.
void add_config(CLI::App& command, ConfigOptions& options);

/// Checks a configuration file, applies the changes, and prints or writes the result. Returns the program's
/// exit code. Throws InputError for an invalid file or change.
int run_config(const ConfigOptions& options);

}  // namespace prosector
