#pragma once
// The edges of tetrahedra as nodes of quadratic elements: they follow the vertices, in the order of their
// ends, the lower one first.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/soft/base/mesh_edit.h"

namespace prosector {

class EdgeNodes {
 public:
  using Edge = std::array<std::uint32_t, 2>;  // vertices, ascending
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  /// The edges of a tetrahedron: pairs of its corners.
  static constexpr std::array<std::array<std::size_t, 2>, 6> edges_of_tet = {
      {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

  /// Finds the edges of tetrahedra that have some of these vertices.
  EdgeNodes(std::span<const std::array<std::uint32_t, 4>> tets, std::size_t vertices);
  /// Finds those of a mesh that has these nodes already, see add_edge_nodes().
  static EdgeNodes of(const TetMesh& mesh);

  std::size_t vertices() const { return vertices_; }
  std::size_t size() const { return edges_.size(); }
  std::span<const Edge> edges() const { return edges_; }
  /// Returns the node on the edge between two vertices, in any order; none: no tetrahedron has it.
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const;
  Edge ends(std::uint32_t node) const { return edges_[node - vertices_]; }

  /// Takes an edit of vertices and corners in. `before`: the mesh whose edges these were. Returns the edit of
  /// all nodes, those on edges included.
  MeshEdit follow(const TetMesh& before, const MeshEdit& corners);

 private:
  /// The edges after an edit.
  struct Merged {
    std::vector<Edge> edges;            // ascending
    std::vector<std::uint32_t> count;   // of each: how many tetrahedra have it
    std::vector<std::uint32_t> is_now;  // by edge before: its node; none: it is gone
  };
  /// Takes the tetrahedra that go or change out of the edges' counts. Returns those edges, by place before.
  std::vector<std::uint32_t> let_go(const TetMesh& before, const MeshEdit& corners);
  /// Adds the tetrahedra that come or changed to the counts, and their edges that were there to `met`.
  /// Returns the others, by vertices now, ascending, each as often as tetrahedra have it.
  std::vector<Edge> take_up(const MeshEdit& corners, std::vector<std::uint32_t>& met);
  /// Merges the edges that stay with those made, ascending, and writes the edit of their nodes into `out`.
  Merged merge(const TetMesh& before, const MeshEdit& corners, std::span<const Edge> made,
               MeshEdit& out) const;
  void index_by_lower_end();

  std::size_t vertices_ = 0;
  std::vector<Edge> edges_;           // ascending
  std::vector<std::uint32_t> count_;  // of each: how many tetrahedra have it
  std::vector<std::uint32_t> begin_;  // by lower vertex: its edges
};

/// Adds the middles of the tetrahedra's edges to the mesh's nodes and ties the surface to what they divide
/// the tetrahedra into.
EdgeNodes add_edge_nodes(Anatomy& anatomy);
/// Tells a point of an edge, a triangle or a tetrahedron, given by its corners, by those of a part. Middles
/// of edges divide it into two, four or eight parts; it is the one in which the point is most inside. Returns
/// the row as it is where an edge is no tetrahedron's.
SparseMap::Row divided(const SparseMap::Row& row, const EdgeNodes& edges);
/// Returns eight linear tetrahedra, all of one volume, on the ten nodes of each: the same nodes.
TetMesh divided(const TetMesh& mesh, const EdgeNodes& edges);
/// Makes `parts` those of `mesh`, which was edited so.
void follow_divided(const TetMesh& mesh, const EdgeNodes& edges, const MeshEdit& edit, TetMesh& parts);

}  // namespace prosector
