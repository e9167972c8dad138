#pragma once
// One clock for all latencies: CLOCK_MONOTONIC, shared by all processes of one machine.

#include <cstdint>

namespace prosector {

/// Returns nanoseconds since an arbitrary start that is the same for every process of this machine.
std::int64_t monotonic_ns();

/// Returns the seconds from `t`, which monotonic_ns() gave, until now.
inline double seconds_since(std::int64_t t) {
  return 1e-9 * static_cast<double>(monotonic_ns() - t);
}

}  // namespace prosector
