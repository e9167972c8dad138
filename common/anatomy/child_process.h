#pragma once
// Runs another program to its end, within limits on time and output. A crash of that program doesn't affect
// the caller.

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
  std::vector<std::uint8_t> output;  // standard output, possibly incomplete
  std::string error;                 // reason of the failure; empty: exit code 0
};

/// Runs `program` with `arguments` and waits for its end. Standard input is empty, and standard error is
/// discarded. Kills the program if it exceeds a limit. Measures time on the monotonic clock.
ChildOutcome run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                       const ChildLimits& limits);

}  // namespace prosector
