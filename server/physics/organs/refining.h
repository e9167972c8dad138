#pragma once
// The station that makes elements smaller where bodies are touched (docs/decisions/0025): what the next tick
// is made of.

#include <span>

#include "server/physics/island.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// Makes what the scene's bodies that may be refined need for it. Throws InputError for one that can't be.
void make_refinable(State& state);

/// Refines bodies where hands, and rigid things that aren't fixed or are driven, pressed or held them in this
/// tick, and takes back what was left long ago. `islands`: of the tick.
void refine_touched(State& state, std::span<const Island> islands, std::span<const Drive> drives);

/// Gives the body its compiled mesh again. Does nothing to one that has it.
void take_refinement_back(State& state, std::size_t body);

/// Returns the body's geometry without refinement: as compiled, or as cut.
const Anatomy& unrefined_anatomy(const State& state, std::size_t body);
/// Returns the content hash of that: clients are told of no refinement.
std::uint64_t topology_hash(const State& state, std::size_t body);

}  // namespace prosector
