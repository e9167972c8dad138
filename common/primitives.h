#pragma once
// Triangle meshes of the primitives that rigid bodies are made of: closed, outward, vertices shared.

#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Bounds on the segments of a primitive's circles, whose triangles are within `chord_error` of them as far
/// as these allow.
inline constexpr int min_segments = 12, max_segments = 48;

/// Makes one part in the body's frame, in metres, its pose applied. `size` is the full extent of every shape:
/// a capsule's height includes its caps, an ellipsoid has three diameters. `rounding` rounds a box's and a
/// cylinder's edges, at most to half the smallest extent. Throws InputError naming an unknown shape or a size
/// that isn't positive.
TriangleMesh mesh_of(const PartDesc& part);

/// Makes all parts as one mesh in the body's frame; parts may overlap, nothing is united.
TriangleMesh mesh_of(std::span<const PartDesc> parts);

}  // namespace prosector
