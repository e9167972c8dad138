#pragma once
// Triangle meshes of the primitives of rigid bodies: closed, facing outward, with shared vertices.

#include <span>

#include "common/mesh.h"
#include "common/scene/scene.h"

namespace prosector {

/// Bounds on the number of segments by which the circles of a rigid body's primitive are approximated. Within
/// these bounds, the number just suffices for the segments to be within `chord_error` (m) of the circle.
inline constexpr int min_segments = 12, max_segments = 48;

/// Builds the mesh of one primitive of a rigid body in the body's frame, in metres, with its pose applied.
/// `size` is the full extent of every shape: a capsule's height includes its caps, an ellipsoid has three
/// diameters. `rounding` rounds the edges of a box or cylinder, by at most half the smallest extent. Throws
/// InputError for an unknown shape or a size that isn't positive.
TriangleMesh mesh_of(const PartDesc& part);

/// Builds the mesh of all primitives of a rigid body in the body's frame. The primitives may overlap; their
/// surfaces are not merged.
TriangleMesh mesh_of(std::span<const PartDesc> parts);

}  // namespace prosector
