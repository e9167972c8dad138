#pragma once
// Checks of a triangle surface for use as a rigid body: closedness, intersections, mass properties.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct SurfaceReport {
  std::size_t open_edges = 0;          // edges without exactly two consistently oriented triangles; 0: closed
  std::size_t intersecting_pairs = 0;  // pairs of intersecting triangles
  double volume = 0;                   // m³, signed: positive when triangles face outward
  Vec3 center_of_mass = Vec3::Zero();  // m, of the enclosed solid
  Mat3 inertia = Mat3::Zero();         // kg m² per kg/m³, about the centre of mass

  /// Returns a warning about the surface's faults for the scene's author; empty if there is none.
  std::string warning() const;
};

/// Finds the pairs of intersecting triangles that have no common vertex. Returns them as pairs of triangle
/// indices.
std::vector<std::array<std::uint32_t, 2>> intersecting_triangles(const TriangleMesh& mesh);

/// Checks a surface: counts open edges and intersecting pairs of triangles, and computes its mass properties
/// by the divergence theorem (exact for closed surfaces).
SurfaceReport check_surface(const TriangleMesh& mesh);

}  // namespace prosector
