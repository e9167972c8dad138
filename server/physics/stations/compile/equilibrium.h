#pragma once
// Equilibrium shape of each soft body under gravity and contacts. Found once per compiled scene by dynamic
// relaxation: implicit steps much longer than a tick, with velocities reset after each.

#include "server/physics/stations/compile/compile_options.h"
#include "server/physics/stations/touching/soft_contact_finder.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Moves each soft body to its equilibrium under gravity and contacts, and puts it to sleep there. A body
/// that nothing supports stays at its initial position, awake. Reports the result, and stores it in the cache
/// of `options`.
void settle(State& state, SoftContactFinder& finder, const CompileOptions& options);

}  // namespace prosector
