#pragma once
// Another program, run to its end within limits; what it does to itself stays there.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

struct ChildLimits {
  double seconds;
  std::size_t output_bytes;
};

struct ChildOutcome {
  std::vector<std::uint8_t> output;  // of standard output, as far as it came
  std::string trouble;               // why it didn't end well; empty: it ended with exit code 0
};

/// Runs `program` with `arguments`, nothing to read and its errors thrown away. Kills it when it exceeds a
/// limit. Waits by the monotonic clock.
ChildOutcome run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                       const ChildLimits& limits);

}  // namespace prosector
