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

/// Prepares each soft body whose description allows local mesh refinement. Throws InputError for a body that
/// can't be refined.
void make_refinable(State& state);

/// Points in soft bodies that may be refined locally: for each body's index, rest positions in m.
using PlacesOfBodies = std::map<std::size_t, std::vector<Vec3>>;

/// Returns the points where hands, and rigid bodies that move or are driven, pressed soft bodies that may be
/// refined locally. `islands` (sets of bodies that are solved together) are those of the tick. Must be called
/// before the tick's cuts, since the contacts refer to the nodes of the uncut mesh.
PlacesOfBodies pressed_places(const State& state, std::span<const coupled::Island> islands,
                              std::span<const KinematicTarget> kinematic_targets);

/// Refines the meshes of bodies at the pressed `places` and where hands hold them, and coarsens them where
/// contact ended long ago.
void refine_touched(State& state, PlacesOfBodies places);

/// Removes the local refinement of the body's mesh: restores the mesh as compiled. Does nothing if the mesh
/// is not refined.
void take_refinement_back(State& state, std::size_t body);

/// Returns the body's geometry without local refinement: as compiled, or as cut since.
const Anatomy& unrefined_anatomy(const State& state, std::size_t body);
/// Returns the content hash of the body's geometry without local refinement, since refinement is not reported
/// to clients.
std::uint64_t topology_hash(const State& state, std::size_t body);

}  // namespace prosector
