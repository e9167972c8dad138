#pragma once
// Mesh grading towards stress singularities, before a body is created (docs/decisions/0026).
//
// Where a fixed face meets a free one, the stress of an elastic solid is singular at the rim. The singularity
// is stronger for less compressible solids (Williams 1952). Meshes graded towards such a rim converge at the
// order of their elements, uniform ones don't (Babuska, Kellogg, Pitkaranta 1979).

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the solid with a finer mesh near the rim of its attachment: edges there are bisected. Returns it
/// unchanged if nothing, or all of the surface, is attached. The surface is unchanged and is embedded in the
/// new mesh. Throws InputError for bodies other than solids, and for flat tetrahedra.
Anatomy graded_at_rims(const SoftDesc& desc, Anatomy anatomy);

}  // namespace prosector
