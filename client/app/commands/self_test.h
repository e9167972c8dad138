#pragma once
// `prosector-client selftest`: records a device for a while, and reports how its records fit its protocol.

#include <filesystem>
#include <string>

namespace CLI {
class App;
}

namespace prosector {

struct SelfTestOptions {
  std::string address;  // address or table of the configuration; empty: the first device of the configuration
  std::filesystem::path config;  // configuration of the device; empty: defaults
  double seconds = 60;
  std::filesystem::path out = "selftest.txt";  // report; the samples are written to the same name with .csv
};

/// Records a device for a while and writes a report on how its records fit its protocol. Returns 0 if
/// everything fits, else another exit code. Throws InputError for an invalid address or if a file can't be
/// written.
int self_test(const SelfTestOptions& options);

/// Adds the options of `prosector-client selftest` to its command. Parsing the command line stores their
/// values in `o`.
void add_self_test(CLI::App& app, SelfTestOptions& o);

}  // namespace prosector
