#pragma once
// What hangs on a soft body's mesh is put in place: when the scene is compiled, and where a cut changes the
// mesh.

#include "server/physics/state.h"

namespace prosector {

/// Fits what others meet of the body to its mesh, whose parts `numbering` numbers. Its `surface` was made or
/// has followed; all other soft bodies are there, for what may meet what decides what is needed. Throws
/// InputError for a solid of the scene that is to meet itself but isn't closed.
void fit_to_mesh(State& state, std::size_t body, Numbering numbering);

/// Returns whether thin bodies may meet, so that checkpoints hold on which sides of each other they are.
bool has_thin_shells(const Bodies& bodies);

}  // namespace prosector
