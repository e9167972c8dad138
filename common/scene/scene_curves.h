#pragma once
// Construction of curves and surface patches from their scene descriptions.

#include <memory>

#include "common/curves/patch.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Builds the curve or patch in the body's frame. Throws InputError that names the error in the description.
NurbsCurve make_curve(const CurveDesc& desc);
std::unique_ptr<Patch> make_patch(const PatchDesc& desc);

/// Builds tubes around all curves and slabs over all patches as one mesh. They may overlap; their surfaces
/// are not merged.
TriangleMesh mesh_of(std::span<const CurveDesc> curves, std::span<const PatchDesc> patches);

}  // namespace prosector
