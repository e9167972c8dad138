#pragma once
// What a mesh is worth: the figures that a scene's author and the simulation need to know of it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/mesh.h"

namespace prosector {

struct TetQuality {
  std::size_t nodes = 0;
  std::size_t tets = 0;
  double volume = 0;              // m³
  double min_dihedral_deg = 180;  // over all tets
  double max_dihedral_deg = 0;
  std::size_t non_manifold_edges = 0;  // boundary edges with other than two boundary triangles
  std::size_t components = 0;          // pieces, joined through faces
};

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
TetQuality tet_quality(const TetMesh& mesh);

/// Returns the faces that belong to one tetrahedron only, counter-clockwise from outside. Their corners are
/// the mesh's nodes, and unused nodes keep their indices.
std::vector<std::array<std::uint32_t, 3>> boundary_faces(const TetMesh& mesh);

/// Returns the component of each tetrahedron, joined through faces, numbered from 0 in order of first
/// appearance.
std::vector<std::uint32_t> tet_components(const TetMesh& mesh);

/// Drops all but the tetrahedra where keep[i], and the nodes that no one uses.
TetMesh subset(const TetMesh& mesh, const std::vector<bool>& keep);

/// Counts the edges of a triangle surface whose number of triangles isn't two (or whose two triangles
/// disagree in orientation): 0 for a closed, orientable 2-manifold.
std::size_t non_manifold_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Returns "3,912 tets, 1,603 ml, dihedral 14.1-151 deg, ..." for progress lines.
std::string describe(const TetQuality& quality);

}  // namespace prosector
