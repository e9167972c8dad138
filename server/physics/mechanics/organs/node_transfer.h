#pragma once
// Interpolation of a body's node fields to the mesh after a cut.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector {

/// Mesh of one body as its solver has it: dense indices, with the ids in an organ's complex. `nodes`
/// (vertices only) and `places` ascend. So a cut that severs nothing appends nodes and tetrahedra and keeps
/// all other indices.
struct PieceMesh {
  std::vector<NodeId> nodes;
  std::vector<TetId> tets, places;  // by tetrahedron: id and TetComplex::place()
  // Mesh with indices into `nodes` and `tets`. A sheet's triangles repeat their last corner. Nodes on edges
  // of quadratic elements follow the vertices, ordered by their end vertices.
  TetMesh mesh;
};

/// Interpolation of node fields from old meshes to a new one. The source of a node is the same node, or a
/// point of the tetrahedron at its position, with shape-function weights. So the new mesh has the shape and
/// motion of the old one. Lumped momentum is conserved to rounding where elements are linear.
class NodeTransfer {
 public:
  /// Finds the sources of the nodes of `now`. `before`: the organ's pieces before the change, any number; the
  /// complex is in its state after the change. `quadratic`: the elements have ten nodes.
  NodeTransfer(const TetComplex& complex, std::span<const PieceMesh* const> before, const PieceMesh& now,
               bool quadratic);
  /// Finds the sources of the nodes that a change made in a single piece. These are `made`, which are the
  /// first new nodes of `edit`, and the new nodes on the edges of `tets`. `edges`: edge nodes before the
  /// change, for quadratic elements.
  NodeTransfer(const TetComplex& complex, const PieceMesh& before, std::span<const NodeId> made,
               std::span<const TetId> tets, const MeshEdit& edit, const EdgeNodes* edges);
  /// Returns the field on the new mesh. `fields`: 3n numbers of each piece in `before`.
  VecX operator()(std::span<const VecX* const> fields) const;
  /// Returns the field of one piece after that edit, which made nodes.
  VecX carried(const VecX& field, const MeshEdit& edit) const;

 private:
  struct Term {
    std::uint32_t piece = 0, node = 0;
    double weight = 0;
  };
  struct Source {
    std::uint32_t count = 0;  // number of terms used
    std::array<Term, 10> terms{};
  };
  static std::optional<Source> within(const TetComplex& complex, std::span<const PieceMesh* const> before,
                                      std::span<const EdgeNodes> edges, TetId tet, const Vec3& rest);
  std::vector<Source> sources_;  // by node of the new mesh
};

}  // namespace prosector
