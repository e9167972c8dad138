#pragma once
// A client's life: join, draw what the replica holds until told to stop, say what it cost.

#include <cstdint>

#include "client/app/options.h"

namespace prosector {

/// Runs the client and returns the exit code. `started_ns`: when the process began (monotonic), to state how
/// long joining took.
int run_client(const ClientOptions& options, std::int64_t started_ns);

}  // namespace prosector
