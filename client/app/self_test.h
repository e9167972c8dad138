#pragma once
// prosector-client selftest: records a device for a while, and says what of it fits its protocol.

#include <filesystem>
#include <string>

namespace prosector {

struct SelfTestOptions {
  std::string address;           // or a table of the configuration; empty: the first device that it names
  std::filesystem::path config;  // how the device is used; empty: by defaults
  double seconds = 60;
  std::filesystem::path out = "selftest.txt";  // the report; beside it, as .csv, the samples
};

/// Runs it, and returns the exit code: 0 where all fits. Throws InputError for an address that is none, and
/// where a file can't be written.
int self_test(const SelfTestOptions& options);

}  // namespace prosector
