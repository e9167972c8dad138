#pragma once
// Fields of a body's nodes, carried over to a mesh that a cut made of it.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/soft/elements/edge_nodes.h"

namespace prosector {

/// The tetrahedra that carry one body, as they were when its solver was made: dense, with the ids in an
/// organ's complex. `nodes` (its vertices only) and `places` ascend, so that a cut which nothing comes off
/// appends nodes and tetrahedra and leaves the others their indices.
struct PieceMesh {
  std::vector<NodeId> nodes;
  std::vector<TetId> tets, places;  // a tetrahedron and its TetComplex::place()
  TetMesh mesh;  // by index in those two, a sheet's triangles with their last corner twice; the nodes on
                 // edges of quadratic elements follow, by their vertices
};

/// Where a node of a new mesh was in an old one: itself, or a point of the tetrahedron that was there, with
/// the weights of its element's shape functions. So a new mesh has the shape and the motion that the old one
/// had. Lumped momentum is kept to rounding where elements are linear.
class NodeTransfer {
 public:
  /// Finds where the nodes of `now` were. `before`: the organ's pieces before the change, any number; the
  /// complex is as it is after it. `quadratic`: the elements have ten nodes.
  NodeTransfer(const TetComplex& complex, std::span<const PieceMesh* const> before, const PieceMesh& now,
               bool quadratic);
  /// Finds where the nodes were that a change made in one piece alone. These are `made`, the first that
  /// `edit` tells of among all its nodes, and those on the edges of `tets`, that it tells of, too. `edges`:
  /// as they were, where elements are quadratic.
  NodeTransfer(const TetComplex& complex, const PieceMesh& before, std::span<const NodeId> made,
               std::span<const TetId> tets, const MeshEdit& edit, const EdgeNodes* edges);
  /// Returns the field on the new mesh. `fields`: 3n numbers of each piece in `before`.
  VecX operator()(std::span<const VecX* const> fields) const;
  /// Returns the field of one piece after that edit, in which nodes were made.
  VecX carried(const VecX& field, const MeshEdit& edit) const;

 private:
  struct Term {
    std::uint32_t piece = 0, node = 0;
    double weight = 0;
  };
  struct Source {
    std::uint32_t count = 0;  // terms used
    std::array<Term, 10> terms{};
  };
  static std::optional<Source> within(const TetComplex& complex, std::span<const PieceMesh* const> before,
                                      std::span<const EdgeNodes> edges, TetId tet, const Vec3& rest);
  std::vector<Source> sources_;  // by node of the new mesh
};

}  // namespace prosector
