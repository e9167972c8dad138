#pragma once
// The surface of a deformable as server and clients both hold it while it is cut: in slots that are never
// used again (SurfacePatch). So what a cut changes is told as a difference, and a hash proves that both hold
// the same.

#include <cstdint>

#include "common/asset.h"
#include "common/mesh.h"
#include "common/messages.h"

namespace prosector {

/// All slots of one deformable, those that nothing uses any more too. Every number is a float's.
struct DrawnSurface {
  TriangleMesh rest;         // m, world frame; a triangle that is gone has its corners equal
  StreamedSurface streamed;  // streamed.map has a row for each of rest.positions
};

/// Returns the nearest float's value.
double to_float(double x);
Vec3 to_float(const Vec3& x);

/// Returns the surface with every number rounded to float: what a client makes of the two assets.
DrawnSurface rounded(TriangleMesh rest, StreamedSurface streamed);

/// Returns what takes `before` to `after`. Appended points are said to be at rest. Throws InternalError when
/// `after` has less of anything, or another place at rest of a point that `before` has: slots are only
/// appended.
SurfacePatch difference(const DrawnSurface& before, const DrawnSurface& after);

/// Changes the surface by the patch. Throws InputError when the patch doesn't fit, and then leaves the
/// surface as it was. What doesn't fit: a slot beyond the next, a vertex on a point or a triangle on a vertex
/// that isn't there, more slots than a surface may have.
void apply(const SurfacePatch& patch, DrawnSurface& surface);

/// Hashes every slot.
std::uint64_t hash(const DrawnSurface& surface);

/// Returns what TopologyRevision::chain_hash has to be: over previous_hash, content_hash, surface_hash,
/// revision and body.
std::uint64_t chain_hash_of(const TopologyRevision& revision);

}  // namespace prosector
