#pragma once
// Main loop of a client: joins, renders the replica until stopped, and reports its measurements.

#include <cstdint>

#include "client/app/run/options.h"

namespace prosector {

/// Runs the client and returns the exit code. `started_ns`: start of the process (monotonic clock), to report
/// the duration of joining.
int run_client(const ClientOptions& options, std::int64_t started_ns);

}  // namespace prosector
