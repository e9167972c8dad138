#pragma once
// `prosector-client config`: checks a configuration, changes keys of it, brings an older one to the present
// version.

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
  bool write = false;                // into `file`; else what would be written is printed
  bool manual = false;               // print the page of all keys
};

/// Adds the options of the command.
void add_config(CLI::App& command, ConfigOptions& options);

/// Does what the options say. Returns the exit code; throws InputError.
int run_config(const ConfigOptions& options);

}  // namespace prosector
