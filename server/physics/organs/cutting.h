#pragma once
// The last phase of a tick: what blades cut, what is undone, and what everything goes back to.

#include <span>

#include "server/physics/organs/blade_grip.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Cuts what blades swept through and obeys what is said of cuts: what the next tick is made of. `grips`: of
/// this tick. Returns whether everything went back to an earlier state, to which the tick's islands don't
/// belong.
bool cut_soft_bodies(State& state, std::span<const BladeGrip> grips, const TickInput& input,
                     StepReport& report);

/// Makes what a first cut asks of each mesh with the scene, so that no tick waits for it.
void make_organs_ready(State& state);

/// Returns, by node of a sheet, what is tied to its place; empty: the body was no sheet.
std::vector<std::uint8_t> held_nodes_of(const State& state, std::size_t body);

}  // namespace prosector
