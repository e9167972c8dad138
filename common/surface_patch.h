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

/// All slots of one deformable's surface, unused ones included. Every number is representable as a float.
struct DrawnSurface {
  TriangleMesh rest;         // m, world frame; a removed triangle has three equal corners
  StreamedSurface streamed;  // streamed.map has a row for each of rest.positions
};

/// Returns the value rounded to the nearest float.
double to_float(double x);
Vec3 to_float(const Vec3& x);

/// Returns the surface with every number rounded to float: equal to the surface that a client decodes from
/// the two assets.
DrawnSurface rounded(TriangleMesh rest, StreamedSurface streamed);

/// Returns the patch that changes `before` to `after`. Appended points are taken to be at rest. Throws
/// InternalError if `after` has fewer slots of any kind, or moves the rest position of an existing point:
/// slots are only appended.
SurfacePatch difference(const DrawnSurface& before, const DrawnSurface& after);

/// Applies the patch to the surface. Throws InputError if the patch doesn't fit, and then leaves the surface
/// unchanged. A patch doesn't fit if it skips a slot, refers to a missing point or vertex, or exceeds the
/// slots that a surface may have.
void apply(const SurfacePatch& patch, DrawnSurface& surface);

/// Returns the hash of all slots.
std::uint64_t hash(const DrawnSurface& surface);

/// Returns the expected TopologyRevision::chain_hash: the hash over previous_hash, content_hash,
/// surface_hash, revision and body.
std::uint64_t chain_hash_of(const TopologyRevision& revision);

}  // namespace prosector
