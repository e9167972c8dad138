#pragma once
// The shape in which each soft body rests under gravity, on the things around it. It is found once per
// compiled scene by dynamic relaxation (implicit steps much longer than a tick, velocities dropped after
// each).

#include "server/physics/contact/soft_contact_finder.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Puts each soft body into its equilibrium, asleep; or leaves it where the scene puts it, where nothing
/// carries it. Says what it found, and keeps it in the cache that `options` name.
void settle(State& state, SoftContactFinder& finder, const CompileOptions& options);

}  // namespace prosector
