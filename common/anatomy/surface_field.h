#pragma once
// The solid that a closed surface bounds, as a field that can be meshed.

#include <string>

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// What keeps a surface from bounding a solid. Edges are counted between vertices that stand apart.
struct SurfaceFaults {
  std::size_t hole_edges = 0;     // of one triangle
  std::size_t crowded_edges = 0;  // of more than two, of which not half run either way: not manifold
  std::size_t opposed_edges = 0;  // of two triangles that face to opposite sides
  Vec3 first = Vec3::Zero();      // the middle of the first such edge, in the surface's units

  explicit operator bool() const { return hole_edges + crowded_edges + opposed_edges > 0; }
  /// Returns what is wrong, where it begins, and what to do.
  std::string in_words() const;
};
SurfaceFaults surface_faults(const TriangleMesh& surface);

/// Returns the volume within a closed surface; negative where its triangles face inward.
double enclosed_volume(const TriangleMesh& surface);

/// What tells inside from outside. `nearest`: the normal of the nearest face, edge or vertex (Bærentzen &
/// Aanæs 2005), for one shell that is a manifold and doesn't cross itself. `winding`: WindingTree, for any
/// closed surface; it takes about twice as long.
enum class Sign { nearest, winding };

/// Returns the signed distance to a closed surface (m), negative inside. Which way its triangles face, as a
/// whole, does not matter. Throws InputError, with surface_faults() in words, where the surface isn't closed.
SolidField solid_within(TriangleMesh surface, Sign sign = Sign::nearest);

}  // namespace prosector
