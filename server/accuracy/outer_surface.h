#pragma once
// The outer faces of a body's elements, and integrals over them.

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "common/mesh.h"
#include "server/accuracy/static_body.h"

namespace prosector {

/// Corners of an outer face of a tetrahedral mesh: three node indices, counter-clockwise seen from outside.
using OuterFace = std::array<std::uint32_t, 3>;

/// Returns the outer faces of the mesh: those that belong to only one tetrahedron, in the tetrahedra's order.
std::vector<OuterFace> outer_faces(const TetMesh& mesh);
Vec3 middle(const TetMesh& mesh, const OuterFace& face);
/// Returns the area vector of a face, m², along its outward normal.
Vec3 area_vector(const TetMesh& mesh, const OuterFace& face);
/// Returns a measure of the body's thickness (m), four times its volume over the area of `faces`. For a long
/// square beam it is the side of the section, for a cube two thirds of its edge.
double thickness(const TetMesh& mesh, const std::vector<OuterFace>& faces);

/// Returns the depth of the body (m), measured from the middle of the outer face `face` inwards along its
/// normal to the first other face. Infinite if there is none.
double depth_below(const TetMesh& mesh, const std::vector<OuterFace>& faces, const OuterFace& face);

/// An integration point on an outer face of a body at rest, with its share of the area and its shape
/// functions.
struct SurfacePoint {
  Vec3 at;                              // m
  double area;                          // m²: its share of the face
  std::array<std::uint32_t, 6> node{};  // the face's corners, then edges
  std::array<double, 6> shape{};        // shape functions; 0 on edges of linear elements
};

/// Calls f for each integration point on the outer faces that `wanted` accepts. On a face with edges of a
/// centimetre there is about one point per millimetre.
void for_surface_points(const StaticBody& body, const std::function<bool(const OuterFace&)>& wanted,
                        const std::function<void(const SurfacePoint&)>& f);

}  // namespace prosector
