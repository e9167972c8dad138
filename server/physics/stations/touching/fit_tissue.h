#pragma once
// Updates the data derived from a soft body's mesh, when the scene is compiled and when a cut changes the
// mesh.

#include "server/physics/world/state.h"

namespace prosector {

/// Updates a soft body's contact geometry for its current mesh, whose permanent numbers are `numbering`. The
/// body's `surface` must be built or updated already. All other soft bodies must exist, since possible
/// contacts determine what is needed. Throws InputError for a solid of the scene with self-contact whose
/// surface isn't closed.
void fit_to_mesh(State& state, std::size_t body, Numbering numbering);

/// Returns whether any thin bodies (sheets or ropes) may touch, so that checkpoints must store on which sides
/// of each other they are.
bool has_thin_shells(const Bodies& bodies);

}  // namespace prosector
