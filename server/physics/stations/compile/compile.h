#pragma once
// Compiles a scene's description into the data that the simulation uses.

#include "server/physics/stations/compile/compile_options.h"
#include "server/physics/world/model.h"

namespace prosector {

/// Builds the meshes, shapes, masses and matrices of a scene's bodies. Throws InputError if the scene is
/// invalid.
CompiledScene compile(const SceneDesc& scene, const CompileOptions& options);

}  // namespace prosector
