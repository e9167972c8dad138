#pragma once
// Edges of tetrahedra as nodes of quadratic elements. Edge nodes follow the vertices and are ordered by their
// ends, the lower one first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

class EdgeNodes {
 public:
  using Edge = std::array<std::uint32_t, 2>;  // vertices, ascending
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  /// Edges of a tetrahedron, as pairs of indices among its four corners, in the order of its edge nodes.
  static constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_tet = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  /// Finds all edges of the tetrahedra `tets`, whose corners must be less than `vertices`, the number of
  /// vertices. Edge nodes are numbered after the vertices.
  EdgeNodes(std::span<const std::array<std::uint32_t, 4>> tets, std::size_t vertices);
  /// Returns the edges of a mesh whose list of nodes already contains the edge nodes after the vertices, as
  /// add_edge_nodes() leaves it.
  static EdgeNodes of(const TetMesh& mesh);

  std::size_t vertices() const { return vertices_; }
  std::size_t size() const { return edges_.size(); }
  std::span<const Edge> edges() const { return edges_; }
  /// Returns the index of the edge node between two vertices, given in any order; `none` if no tetrahedron
  /// has this edge.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
  Edge ends(std::uint32_t node) const { return edges_[node - vertices_]; }

  /// Updates the edges after the edit `corners` of vertices and tetrahedra. `before`: the mesh before the
  /// edit. Returns the same edit for all nodes, with new, moved and removed edge nodes.
  MeshEdit follow(const TetMesh& before, const MeshEdit& corners);

 private:
  /// Edges of a tetrahedral mesh after an edit, with the number of tetrahedra at each, and the new node index
  /// of each previous edge.
  struct Merged {
    std::vector<Edge> edges;            // ascending
    std::vector<std::uint32_t> count;   // by edge: number of tetrahedra at the edge
    std::vector<std::uint32_t> is_now;  // by edge before: its present node; none: removed
  };
  /// Subtracts the tetrahedra that the edit `corners` removed or changed from the number of tetrahedra at
  /// each edge. Returns the edges of these tetrahedra, by their previous index. `before`: the mesh before the
  /// edit.
  std::vector<std::uint32_t> let_go(const TetMesh& before, const MeshEdit& corners);
  /// Adds the tetrahedra that the edit `corners` created or changed to the number of tetrahedra at each edge.
  /// Appends their existing edges, by previous index, to `met`. Returns their new edges, by present vertices,
  /// ascending, once for each tetrahedron at the edge.
  std::vector<Edge> take_up(const MeshEdit& corners, std::vector<std::uint32_t>& met);
  /// Merges the edges that still have tetrahedra with the new edges `made` (ascending). Writes the
  /// corresponding edit of the edge nodes to `out`. `before`: the mesh before the edit `corners`.
  Merged merge(const TetMesh& before, const MeshEdit& corners, std::span<const Edge> made,
               MeshEdit& out) const;
  void index_by_lower_end();

  std::size_t vertices_ = 0;
  std::vector<Edge> edges_;           // ascending
  std::vector<std::uint32_t> count_;  // by edge: number of tetrahedra at the edge
  std::vector<std::uint32_t> begin_;  // by lower vertex: start of its edges
};

/// Appends the edge midpoints to the nodes of the mesh, and returns the edges. Re-embeds the surface in the
/// eight parts into which the midpoints divide each tetrahedron.
EdgeNodes add_edge_nodes(Anatomy& anatomy);
/// Returns the weights of an embedded point for the corners of a part of its edge, triangle or tetrahedron,
/// instead of the corners of the whole. Edge midpoints divide the whole into two, four or eight parts. The
/// part with the largest minimum weight is used. Returns the row unchanged if one of the edges belongs to no
/// tetrahedron.
SparseMap::Row divided(const SparseMap::Row& row, const EdgeNodes& edges);
/// Returns a mesh with eight linear tetrahedra of equal volume for each tetrahedron of `mesh`, on its four
/// vertices and six edge nodes.
TetMesh divided(const TetMesh& mesh, const EdgeNodes& edges);
/// Updates `parts`, the mesh with eight linear tetrahedra for each tetrahedron of `mesh`, after `edit`
/// changed `mesh`. Only the parts of new and changed tetrahedra are recomputed.
void follow_divided(const TetMesh& mesh, const EdgeNodes& edges, const MeshEdit& edit, TetMesh& parts);

}  // namespace prosector::soft
