#pragma once
// Quality measures and connectivity of tetrahedral meshes.

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
  double min_dihedral_deg = 180;  // over all tetrahedra
  double max_dihedral_deg = 0;
  std::size_t non_manifold_edges = 0;  // boundary edges that don't have exactly two boundary triangles
  std::size_t components = 0;          // face-connected components
};

double tet_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Least and greatest dihedral angle, degrees.
struct DihedralRange {
  double least_deg = 180, most_deg = 0;
};
/// Returns the range of a tetrahedron's dihedral angles. `x`: its nodes, of positive volume.
DihedralRange dihedral_range(const std::array<Vec3, 4>& x);

TetQuality tet_quality(const TetMesh& mesh);

/// Returns the mesh's boundary faces (those of only one tetrahedron), counter-clockwise seen from outside, as
/// indices of the mesh's nodes.
std::vector<std::array<std::uint32_t, 3>> boundary_faces(const TetMesh& mesh);

/// Returns, for each tetrahedron, the index of its face-connected component. Components are numbered from 0
/// in order of first appearance.
std::vector<std::uint32_t> tet_components(const TetMesh& mesh);

/// Returns the mesh that consists of the tetrahedra i with keep[i] true, without unused nodes.
TetMesh subset(const TetMesh& mesh, const std::vector<bool>& keep);

/// Returns the number of edges of a triangle surface that do not have exactly two triangles of consistent
/// orientation. It is 0 for a closed, orientable 2-manifold.
std::size_t non_manifold_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// Returns a summary of the mesh's quality for progress lines, such as "3,912 tets, 1,603 ml, dihedral
/// 14.1-151 deg, ...".
std::string describe(const TetQuality& quality);

}  // namespace prosector
