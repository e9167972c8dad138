#pragma once
// Quadratic tetrahedra of ten nodes, straight-sided at rest: vertices and edge midpoints.
//
// With L_c the barycentric coordinates and D_c = ∂x/∂L_c (quadratic fields: linear in L),
//   F = Σ_c D_c g_cᵀ,  g_c = ∇L_c at rest,  D_c = (4L_c − 1)·x_c + 4·Σ_{d≠c} L_d x_cd.
// So each integration point is a linear tetrahedron with corners D_c, and uses the code for linear tetrahedra
// (tet4.h, element_batches.h). The matrix T_q maps node positions to the D_c of point q. It gives forces
// T_qᵀf and stiffness T_qᵀK T_q. Four points integrate the stiffness exactly if the law is linear.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/soft/base/connectivity.h"
#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/elements/tet4.h"

namespace prosector::soft {

class Tet10Elements {
 public:
  static constexpr std::size_t nodes_per_element = 10, points_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  /// Edges of the tetrahedron, as pairs of its four vertices. Node 4 + k of an element is on edge k.
  static constexpr auto& edge = EdgeNodes::edges_of_tet;

  /// Creates quadratic elements for all tetrahedra of `mesh`, whose nodes must include the edge nodes
  /// (add_edge_nodes()). Tetrahedra that are too flat are left out, see Tet4Elements::least_quality. Each
  /// element's nodes ascend: its vertices, then its edge nodes.
  explicit Tet10Elements(const TetMesh& mesh);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return corners_.dropped(); }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns the index in the mesh of the tetrahedron of element e. Indices differ if flat tetrahedra were
  /// left out.
  std::uint32_t source(std::size_t e) const { return corners_.source()[e]; }
  /// Returns for each integration point, four per element, the index in the mesh of its tetrahedron.
  std::vector<std::uint32_t> point_source() const;
  /// Returns the lumped volume of each node, n, m³, including tetrahedra without an element. It is the
  /// diagonal of the consistent mass matrix, scaled to the correct total (Hinton, Rock, Zienkiewicz 1976). An
  /// element of volume V gives V/36 to each vertex and 4V/27 to each edge node. All values are positive,
  /// unlike row sums, which are negative at vertices.
  const VecX& lumped_volume() const { return volume_; }
  /// Returns for each node the integral of its shape function over the body, n, m³. An element of volume V
  /// contributes −V/20 to each vertex and V/5 to each edge node.
  const VecX& shape_volume() const { return shape_volume_; }

  /// Returns the integration points as linear tetrahedra without common corners, each with a quarter of its
  /// element's volume. Points 4e … 4e + 3 belong to element e.
  Tet4Elements points() const { return Tet4Elements::parted(corners_, points_per_element); }

  /// Returns the linear tetrahedra with the same vertices as the quadratic elements, in the same order.
  const Tet4Elements& corners() const { return corners_; }

  // ---- Updates after a cut
  /// Returns whether follow() can update the elements after an edit of the mesh: no tetrahedron was or must
  /// be left out as too flat. `rest`: rest positions before the edit (3n, m); `corners`: the edit of the
  /// vertices.
  bool can_follow(const VecX& rest, const MeshEdit& corners) const {
    return corners_.can_follow(rest, corners);
  }
  /// Updates the elements after `edit` changed the mesh and its edge nodes to `mesh`. Does not update the
  /// nodes' volumes. follow_volume() does that afterwards, from the updated `connectivity` and `incidence` of
  /// the elements.
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  void follow_volume(const TetMesh& mesh, const MeshEdit& edit, const Connectivity& connectivity,
                     const Incidence& incidence);

  /// Represents the strain at each of the four integration points of element e by a linear tetrahedron with
  /// the same deformation gradient. Computes the corners of these tetrahedra at node positions x (3n, m).
  /// Writes 3 numbers per corner, 48 in all, to `to`.
  void move(std::size_t e, const double* x, double* to) const;
  /// Computes the forces on the ten nodes of an element from the forces f on the corners of its four
  /// integration points: the sum of T_qᵀf. T_q maps node positions to the corners of point q.
  static void gather(const Tet4Elements::Forces* points, Vec3* f);
  /// Computes an element's stiffness from the stiffnesses K of its four integration points: the sum of T_qᵀK
  /// T_q. T_q maps node positions to the corners of point q. Writes one block per pair of nodes a < b, in the
  /// order of Connectivity::pair_index.
  static void gather(const Tet4Elements::Stiffness* points, Mat3* K);
  /// Constant factors for the trace of an element's stiffness at rest, relative to Σ|b_c|². That is the sum
  /// of squared shape gradients of the linear tetrahedron with the same vertices. g_n: gradient of node n's
  /// shape function at an integration point. `squares_of_points` is for the sum of |g_n|² over points and
  /// nodes. `squares_of_sums` is for the sum over nodes of |Σ over points of g_n|².
  static const double squares_of_points, squares_of_sums;
  /// Computes the gradients r[40] of an element's ten shape functions at its four integration points, from
  /// `corners`[16], those of the linear tetrahedra that represent the points (see move()).
  static void spread(const CorotatedVector* corners, CorotatedVector* r);

 private:
  Tet4Elements corners_;
  std::vector<Nodes> nodes_;
  VecX volume_, shape_volume_;
};

}  // namespace prosector::soft
