#pragma once
// Construction of curves and surface patches from their scene descriptions.

#include <memory>

#include "common/curves/patch.h"
#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Builds a curve in the body's frame from its description in the scene; make_patch() builds a surface patch.
/// Throws InputError that names the error in the description.
NurbsCurve make_curve(const CurveDesc& desc);
std::unique_ptr<Patch> make_patch(const PatchDesc& desc);

/// Builds one mesh of a rigid body's tubes around all curves and slabs over all surface patches. They may
/// overlap; their surfaces are not merged.
TriangleMesh mesh_of(std::span<const CurveDesc> curves, std::span<const PatchDesc> patches);

}  // namespace prosector
