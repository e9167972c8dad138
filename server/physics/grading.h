#pragma once
// Smaller elements where stress is singular, before a body is made (docs/decisions/0026).
//
// Where a face that is fixed meets a free one, stress of an elastic solid grows without bound towards the
// rim. The less compressible it is, the faster (Williams 1952). Meshes that are graded towards such a rim
// converge at the order of their elements again, uniform ones don't (Babuska, Kellogg, Pitkaranta 1979).

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Returns the solid with edges near the rim of what is attached bisected; as it is, where nothing is, or all
/// of the surface. Its surface stays, and hangs on what is there then. Throws InputError for what is no
/// solid, or has flat tetrahedra.
Anatomy graded_at_rims(const SoftDesc& desc, Anatomy anatomy);

}  // namespace prosector
