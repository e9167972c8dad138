#pragma once
// The station that makes elements smaller where bodies are touched (docs/decisions/0025): what the next tick
// is made of.

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "server/physics/island.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Makes what the scene's bodies that may be refined need for it. Throws InputError for one that can't be.
void make_refinable(State& state);

/// Places of bodies that may be refined, by soft body: m, at rest.
using PlacesOfBodies = std::map<std::size_t, std::vector<Vec3>>;

/// Returns where hands, and rigid things that aren't fixed or are driven, pressed bodies that may be refined.
/// `islands`: of the tick. Their nodes are those of the mesh that it was stepped with, so no cut comes
/// before.
PlacesOfBodies pressed_places(const State& state, std::span<const Island> islands,
                              std::span<const Drive> drives);

/// Refines bodies at the pressed `places` and where they are held, and takes back what was left long ago.
void refine_touched(State& state, PlacesOfBodies places);

/// Gives the body its compiled mesh again. Does nothing to one that has it.
void take_refinement_back(State& state, std::size_t body);

/// Returns the body's geometry without refinement: as compiled, or as cut.
const Anatomy& unrefined_anatomy(const State& state, std::size_t body);
/// Returns the content hash of that: clients are told of no refinement.
std::uint64_t topology_hash(const State& state, std::size_t body);

}  // namespace prosector
