#pragma once
// Interpolation of a body's node fields to the mesh after a cut.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector::organs {

/// Mesh of one connected piece of a cut organ, with dense indices as its solver uses them. It maps each index
/// to the id of the node or tetrahedron in the organ's mesh. `nodes` (vertices only) and `places` (sort keys
/// of the tetrahedra) ascend. So a cut that severs nothing only appends nodes and tetrahedra and keeps all
/// other indices.
struct PieceMesh {
  std::vector<cutting::NodeId> nodes;
  std::vector<cutting::TetId> tets, places;  // by tetrahedron: id and TetComplex::place()
  // Mesh with indices into `nodes` and `tets`. A sheet's triangles repeat their last corner. Nodes on edges
  // of quadratic elements follow the vertices, ordered by their end vertices.
  TetMesh mesh;
};

/// Interpolation of node fields, such as positions and velocities, from the meshes before a cut to one mesh
/// after it. A node that existed before keeps its value. A new node gets the value at its rest position in
/// the old tetrahedron there, by shape functions. So the new mesh has the shape and motion of the old one.
/// The total momentum with lumped masses is conserved to rounding where elements are linear.
class NodeTransfer {
 public:
  /// Finds for each node of the piece `now` the old nodes and weights from which its field values are
  /// interpolated. `complex`: the organ's mesh after the change; `before`: all its pieces before the change.
  /// `quadratic`: the elements have ten nodes.
  NodeTransfer(const cutting::TetComplex& complex, std::span<const PieceMesh* const> before,
               const PieceMesh& now, bool quadratic);
  /// Finds, for a change within a single piece, the old nodes and weights from which each new node is
  /// interpolated. The new nodes are `made` (ids), which come first among the new nodes of `edit`, and the
  /// new edge nodes of `tets`. `edges`: edge nodes of quadratic elements before the change; null for linear
  /// elements.
  NodeTransfer(const cutting::TetComplex& complex, const PieceMesh& before,
               std::span<const cutting::NodeId> made, std::span<const cutting::TetId> tets,
               const soft::MeshEdit& edit, const soft::EdgeNodes* edges);
  /// Returns a field on the new mesh, 3 values per node, interpolated from the old meshes. `fields`: for each
  /// old piece, in the order given to the constructor, 3 values per node.
  VecX operator()(std::span<const VecX* const> fields) const;
  /// Returns a field, 3 values per node, after `edit` was applied to a single piece: surviving nodes keep
  /// their values in `field`, and new nodes get interpolated values. Requires the constructor that takes a
  /// MeshEdit.
  VecX carried(const VecX& field, const soft::MeshEdit& edit) const;

 private:
  struct Term {
    std::uint32_t piece = 0, node = 0;
    double weight = 0;
  };
  struct Source {
    std::uint32_t count = 0;  // number of terms used
    std::array<Term, 10> terms{};
  };
  static std::optional<Source> within(const cutting::TetComplex& complex,
                                      std::span<const PieceMesh* const> before,
                                      std::span<const soft::EdgeNodes> edges, cutting::TetId tet,
                                      const Vec3& rest);
  std::vector<Source> sources_;  // by node of the new mesh
};

}  // namespace prosector::organs
