#pragma once
// Local refinement of elements near contacts (docs/decisions/0025), for the next tick.

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_input.h"

namespace prosector {

/// Prepares the scene's bodies that may be refined. Throws InputError for a body that can't be refined.
void make_refinable(State& state);

/// Points by refinable soft body: m, rest positions.
using PlacesOfBodies = std::map<std::size_t, std::vector<Vec3>>;

/// Returns the points where hands, and rigid bodies that move or are driven, pressed refinable bodies.
/// `islands`: of the tick. Must be called before cuts, since the nodes are those of the tick's mesh.
PlacesOfBodies pressed_places(const State& state, std::span<const Island> islands,
                              std::span<const KinematicTarget> kinematic_targets);

/// Refines bodies at the pressed `places` and where they are held, and coarsens them where contact ended long
/// ago.
void refine_touched(State& state, PlacesOfBodies places);

/// Restores the body's compiled mesh. Does nothing if the body is not refined.
void take_refinement_back(State& state, std::size_t body);

/// Returns the body's geometry without refinement: as compiled, or as cut.
const Anatomy& unrefined_anatomy(const State& state, std::size_t body);
/// Returns the content hash of unrefined_anatomy(), since refinement is not reported to clients.
std::uint64_t topology_hash(const State& state, std::size_t body);

}  // namespace prosector
