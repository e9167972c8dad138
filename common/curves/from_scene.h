#pragma once
// Curves and pieces of surfaces as scenes describe them.

#include <memory>

#include "common/curves/patch.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Makes the curve or patch in the body's frame. Throws InputError saying what of the description is wrong.
NurbsCurve make_curve(const CurveDesc& desc);
std::unique_ptr<Patch> make_patch(const PatchDesc& desc);

/// Makes tubes around all curves and slabs over all patches, as one mesh; they may overlap, nothing is
/// united.
TriangleMesh mesh_of(std::span<const CurveDesc> curves, std::span<const PatchDesc> patches);

}  // namespace prosector
