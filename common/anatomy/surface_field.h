#pragma once
// The solid that a closed surface bounds, as a field that can be meshed.

#include <string>

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// What keeps a surface from bounding a solid. Edges are counted between vertices that stand apart.
struct SurfaceFaults {
  std::size_t hole_edges = 0;     // of one triangle
  std::size_t crowded_edges = 0;  // of more than two: the surface is no manifold there
  std::size_t opposed_edges = 0;  // of two triangles that face to opposite sides
  Vec3 first = Vec3::Zero();      // the middle of the first such edge, in the surface's units

  explicit operator bool() const { return hole_edges + crowded_edges + opposed_edges > 0; }
  /// Returns what is wrong, where it begins, and what to do.
  std::string in_words() const;
};
SurfaceFaults surface_faults(const TriangleMesh& surface);

/// Returns the volume within a closed surface; negative where its triangles face inward.
double enclosed_volume(const TriangleMesh& surface);

/// Counts the surface's pieces that hang together through vertices.
std::size_t surface_pieces(const TriangleMesh& surface);

/// Returns the signed distance to a closed surface (m), negative inside; which way its triangles face does
/// not matter. Its sign is that of the nearest face's, edge's or vertex's normal (Bærentzen & Aanæs 2005).
/// Throws InputError, with surface_faults() in words, where the surface isn't closed.
SolidField solid_within(TriangleMesh surface);

}  // namespace prosector
