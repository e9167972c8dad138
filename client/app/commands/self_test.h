#pragma once
// `prosector-client selftest`: records a device for a while, and reports how its records fit its protocol.

#include <filesystem>
#include <string>

namespace prosector {

struct SelfTestOptions {
  std::string address;  // address or table of the configuration; empty: the first device of the configuration
  std::filesystem::path config;  // configuration of the device; empty: defaults
  double seconds = 60;
  std::filesystem::path out = "selftest.txt";  // report; the samples are written to the same name with .csv
};

/// Runs the self-test. Returns 0 if everything fits, else another exit code. Throws InputError for an invalid
/// address or if a file can't be written.
int self_test(const SelfTestOptions& options);

}  // namespace prosector
