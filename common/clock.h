#pragma once
// The clock of all latency measurements: CLOCK_MONOTONIC, shared by all processes of a machine.

#include <cstdint>

namespace prosector {

/// Returns the time in nanoseconds since an arbitrary start, which is the same for all processes of this
/// machine.
std::int64_t monotonic_ns();

/// Returns the time in seconds from `t`, a value of monotonic_ns(), until now.
inline double seconds_since(std::int64_t t) {
  return 1e-9 * static_cast<double>(monotonic_ns() - t);
}

}  // namespace prosector
