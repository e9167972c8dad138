#pragma once
// Signed distance field of the solid inside a closed surface.

#include <string>

#include "common/anatomy/field.h"
#include "common/mesh.h"

namespace prosector {

/// Numbers of faults that prevent a surface from bounding a solid: edges at holes, of too many triangles, or
/// with opposite orientations. Edges are counted between vertices at different positions.
struct SurfaceFaults {
  std::size_t hole_edges = 0;     // of one triangle only
  std::size_t crowded_edges = 0;  // of more than two triangles, not half in each direction: not manifold
  std::size_t opposed_edges = 0;  // of two triangles with opposite orientation
  Vec3 first = Vec3::Zero();      // midpoint of the first faulty edge, in the surface's units

  explicit operator bool() const { return hole_edges + crowded_edges + opposed_edges > 0; }
  /// Returns a message for users with the surface's faults, the position of the first one, and a remedy.
  std::string in_words() const;
};
SurfaceFaults surface_faults(const TriangleMesh& surface);

/// Returns the volume inside a closed surface, in cubed units of its positions. Negative if its triangles
/// face inward.
double enclosed_volume(const TriangleMesh& surface);

/// Method by which the sign of the distance to a closed surface is found. `nearest` uses the pseudonormal of
/// the nearest face, edge or vertex (Bærentzen & Aanæs 2005), for one manifold shell without
/// self-intersections. `winding` uses winding numbers, for any closed surface; it takes about twice as long.
enum class Sign { nearest, winding };

/// Returns the solid inside a closed surface as its signed distance field (m), negative inside. Triangles may
/// face all inward or all outward. Throws InputError with the text of surface_faults() if the surface isn't
/// closed.
SolidField solid_within(TriangleMesh surface, Sign sign = Sign::nearest);

}  // namespace prosector
