#pragma once
// Main loop of a client: joins, renders the replica until stopped, and reports its measurements.

#include <cstdint>

#include "client/app/run/options.h"

namespace prosector {

/// Joins the session, renders it until the user ends it, and returns the program's exit code. `started_ns`:
/// start of the process (monotonic clock), from which the duration of joining is reported.
int run_client(const ClientOptions& options, std::int64_t started_ns);

}  // namespace prosector
