#pragma once
// Bodies that a scene places in each other.

#include "server/physics/stations/compile/compile_options.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Checks the bodies of a scene at their initial positions. Throws InputError, with the names of both, if the
/// centre of mass of a free rigid body is inside a solid that it may touch: nothing would separate them.
/// Reports pairs of solids that overlap deeper than a quarter of a surface cell; these are led apart.
void check_overlaps(State& state, const CompileOptions& options);

}  // namespace prosector
