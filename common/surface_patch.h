#pragma once
// The surface of a deformable as server and clients store it during cutting: in slots that are never reused
// (SurfacePatch). A cut is therefore sent as a difference, and a hash verifies that both surfaces are equal.

#include <cstdint>

#include "common/asset.h"
#include "common/body_messages.h"
#include "common/math.h"
#include "common/mesh.h"
#include "common/surface_change.h"

namespace prosector {

/// Drawn surface of a soft body as server and clients store it: all slots (permanent indices) of points,
/// vertices and triangles, unused ones included. Every number is representable as a float.
struct DrawnSurface {
  TriangleMesh rest;         // m, world frame; a removed triangle has three equal corners
  StreamedSurface streamed;  // streamed.map has a row for each of rest.positions
};

/// Returns the value, or each component, rounded to the nearest single-precision number.
double to_float(double x);
Vec3 to_float(const Vec3& x);

/// Returns the drawn surface of a soft body with every number rounded to float. It equals the surface that a
/// client decodes from the two assets.
DrawnSurface rounded(TriangleMesh rest, StreamedSurface streamed);

/// Returns the patch that changes the drawn surface `before` to `after`. Appended points are taken to be at
/// rest. Throws InternalError if `after` has fewer slots (permanent indices) of points, vertices or
/// triangles, or moves the rest position of an existing point: slots are only appended.
SurfacePatch difference(const DrawnSurface& before, const DrawnSurface& after);

/// Applies the patch to the drawn surface of a soft body. Throws InputError if the patch doesn't fit, and
/// then leaves the surface unchanged. A patch doesn't fit if it skips a slot (permanent index), refers to a
/// missing point or vertex, or exceeds the slots that a surface may have.
void apply(const SurfacePatch& patch, DrawnSurface& surface);

/// Returns the hash of all slots (permanent indices) of points, vertices and triangles of a drawn surface,
/// including unused ones.
std::uint64_t hash(const DrawnSurface& surface);

/// Returns the chain hash that a topology revision must have: the hash over its previous_hash, content_hash,
/// surface_hash, revision and body.
std::uint64_t chain_hash_of(const TopologyRevision& revision);

}  // namespace prosector
