#pragma once
// One clock for all latencies: CLOCK_MONOTONIC, shared by all processes of one machine.

#include <cstdint>

namespace prosector {

/// Nanoseconds since an arbitrary start that is the same for every process of this machine.
std::int64_t monotonic_ns();

}  // namespace prosector
