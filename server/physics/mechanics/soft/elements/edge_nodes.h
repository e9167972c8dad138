#pragma once
// Edges of tetrahedra as nodes of quadratic elements. Edge nodes follow the vertices and are ordered by their
// ends, the lower one first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector {

class EdgeNodes {
 public:
  using Edge = std::array<std::uint32_t, 2>;  // vertices, ascending
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  /// Edges of a tetrahedron, as pairs of its corners.
  static constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_tet = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  /// Finds the edges of tetrahedra whose corners are some of these vertices.
  EdgeNodes(std::span<const std::array<std::uint32_t, 4>> tets, std::size_t vertices);
  /// Finds the edges of a mesh that already has edge nodes, see add_edge_nodes().
  static EdgeNodes of(const TetMesh& mesh);

  std::size_t vertices() const { return vertices_; }
  std::size_t size() const { return edges_.size(); }
  std::span<const Edge> edges() const { return edges_; }
  /// Returns the node on the edge between two vertices, in any order; none if no tetrahedron has this edge.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
  Edge ends(std::uint32_t node) const { return edges_[node - vertices_]; }

  /// Applies an edit of vertices and corners. `before`: the mesh to which the edges belonged. Returns the
  /// edit of all nodes, edge nodes included.
  MeshEdit follow(const TetMesh& before, const MeshEdit& corners);

 private:
  /// The edges after an edit.
  struct Merged {
    std::vector<Edge> edges;            // ascending
    std::vector<std::uint32_t> count;   // by edge: number of tetrahedra at the edge
    std::vector<std::uint32_t> is_now;  // by edge before: its present node; none: removed
  };
  /// Subtracts removed and changed tetrahedra from the edges' counts. Returns the edges of these tetrahedra,
  /// by their previous index.
  std::vector<std::uint32_t> let_go(const TetMesh& before, const MeshEdit& corners);
  /// Adds new and changed tetrahedra to the counts, and appends their existing edges to `met`. Returns their
  /// other edges, by present vertices, ascending, once for each tetrahedron at the edge.
  std::vector<Edge> take_up(const MeshEdit& corners, std::vector<std::uint32_t>& met);
  /// Merges the remaining edges with the new edges `made` (ascending), and writes the edit of their nodes to
  /// `out`.
  Merged merge(const TetMesh& before, const MeshEdit& corners, std::span<const Edge> made,
               MeshEdit& out) const;
  void index_by_lower_end();

  std::size_t vertices_ = 0;
  std::vector<Edge> edges_;           // ascending
  std::vector<std::uint32_t> count_;  // by edge: number of tetrahedra at the edge
  std::vector<std::uint32_t> begin_;  // by lower vertex: start of its edges
};

/// Adds the edge midpoints to the mesh's nodes, and embeds the surface in the parts into which they divide
/// the tetrahedra.
EdgeNodes add_edge_nodes(Anatomy& anatomy);
/// Expresses a point of an edge, triangle or tetrahedron by the corners of a part instead of the corners of
/// the whole. Edge midpoints divide it into two, four or eight parts, and the part with the largest minimum
/// weight is chosen. Returns the row unchanged if an edge belongs to no tetrahedron.
SparseMap::Row divided(const SparseMap::Row& row, const EdgeNodes& edges);
/// Returns eight linear tetrahedra of equal volume for each tetrahedron of `mesh`, on the same ten nodes.
TetMesh divided(const TetMesh& mesh, const EdgeNodes& edges);
/// Updates `parts`, the divided mesh, after an edit of `mesh`.
void follow_divided(const TetMesh& mesh, const EdgeNodes& edges, const MeshEdit& edit, TetMesh& parts);

}  // namespace prosector
