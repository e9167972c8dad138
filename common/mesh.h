#pragma once
// Meshes as plain data, and the sparse map that embeds a surface in tetrahedra.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Default bound (m) on the distance between a curved surface and the triangles that approximate it.
inline constexpr double chord_error = 0.25e-3;  // m

/// A triangle surface: vertex positions and triangles, which are counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> positions;                          // metres
  std::vector<std::array<std::uint32_t, 3>> triangles;  // into positions
  std::vector<std::uint8_t> inner = {};                 // per triangle: 1 if a cut exposed it; empty: none
};

/// Appends the vertices and triangles of `mesh` to those of `all`, without merging any vertices.
inline void append(TriangleMesh& all, const TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(all.positions.size());
  all.positions.insert(all.positions.end(), mesh.positions.begin(), mesh.positions.end());
  for (const auto& t : mesh.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

class RestStretch;

/// A volume mesh of linear tetrahedra, whose corners x0 … x3 are ordered so that det(x1−x0, x2−x0, x3−x0) >
/// 0.
struct TetMesh {
  std::vector<Vec3> positions;                      // metres
  std::vector<std::array<std::uint32_t, 4>> tets;   // into positions
  std::shared_ptr<const RestStretch> stretch = {};  // of prestressed tissue; null: no prestress
};

/// Sparse map W from nodes to surface vertices: x_surface = W·x_nodes and, transposed, f_nodes =
/// Wᵀ·f_surface. A row has at most 4 nodes, and its weights sum to 1. Surface vertices add no degrees of
/// freedom; a surface may be finer or coarser than the elements that carry it.
struct SparseMap {
  struct Row {
    std::array<std::uint32_t, 4> node{};  // unused entries: weight 0
    std::array<double, 4> weight{};
  };
  std::vector<Row> rows;

  Vec3 apply(std::size_t row, const double* nodes) const {
    const Row& r = rows[row];
    Vec3 x = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) x += r.weight[k] * Eigen::Map<const Vec3>(nodes + 3 * r.node[k]);
    return x;
  }
};

/// Geometry of a soft body: the simulation mesh and its embedded surface, which is drawn and used for
/// contact. The simulation mesh has tetrahedra, cells of a sheet, or segments of a rope; tets.positions are
/// its nodes.
struct Anatomy {
  TetMesh tets;
  TriangleMesh surface;  // rest shape; surface.positions[i] = W.row(i)·tets.positions
  SparseMap embedding;   // W, one row per surface vertex
  std::vector<std::array<std::uint32_t, 4>> quads = {};  // cells of a sheet, corners in order: a, b, c, d
  std::vector<std::array<std::uint32_t, 3>> triangles =
      {};  // cells of a sheet that a cut turned into triangles
  std::vector<std::array<std::uint32_t, 2>> segments = {};  // segments of a rope
  double thickness = 0;                                     // m: thickness of a sheet, diameter of a rope
  std::vector<double> node_volume = {};  // m³, of a sheet with cuts; empty: lumped from the elements
};

/// Returns the diameter (m) of the rope; 0 if the soft body is not a rope.
inline double tube_diameter(const Anatomy& anatomy) {
  return anatomy.segments.empty() ? 0 : anatomy.thickness;
}

}  // namespace prosector
