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

namespace prosector {

class Tet10Elements {
 public:
  static constexpr std::size_t nodes_per_element = 10, points_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  /// The vertices of edge node 4 + k.
  static constexpr auto& edge = EdgeNodes::edges_of_tet;

  /// Creates the elements of `mesh`, which must have edge nodes, see add_edge_nodes. Elements that are too
  /// flat are left out as in tet4.h. Each element's nodes ascend: its vertices, then its edge nodes.
  explicit Tet10Elements(const TetMesh& mesh);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return corners_.dropped(); }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns the index of the mesh's tetrahedron that is this element.
  std::uint32_t source(std::size_t e) const { return corners_.source()[e]; }
  /// Returns, by integration point, the index of its tetrahedron in the mesh.
  std::vector<std::uint32_t> point_source() const;
  /// Returns the volume of each node, m³, dropped elements included: the diagonal of the consistent mass
  /// matrix, scaled to the correct total (Hinton, Rock, Zienkiewicz 1976). Vertices get V/36, edge nodes
  /// 4V/27. All values are positive; row sums would be negative at vertices.
  const VecX& lumped_volume() const { return volume_; }
  /// Returns the volume of each node by the integrals of the shape functions, m³: −V/20 at vertices, V/5 at
  /// edge nodes.
  const VecX& shape_volume() const { return shape_volume_; }

  /// Returns the integration points as linear tetrahedra without common corners, each with a quarter of the
  /// element's volume. Points 4e … 4e + 3 belong to element e.
  Tet4Elements points() const { return Tet4Elements::parted(corners_, points_per_element); }

  /// Returns the elements as linear tetrahedra.
  const Tet4Elements& corners() const { return corners_; }

  // ---- Updates after a cut
  /// Returns whether the elements can follow the edit, see tet4.h. `corners`: the edit of the vertices.
  bool can_follow(const VecX& rest, const MeshEdit& corners) const {
    return corners_.can_follow(rest, corners);
  }
  /// Updates the elements after an edit of `mesh` and its edge nodes, except the volumes. follow_volume()
  /// updates these from the elements' updated connectivity and incidence.
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  void follow_volume(const TetMesh& mesh, const MeshEdit& edit, const Connectivity& connectivity,
                     const Incidence& incidence);

  /// Computes D_c of the four points of element e at node positions x (3n), 3 numbers per corner: to[48].
  void move(std::size_t e, const double* x, double* to) const;
  /// Computes T_qᵀf summed over the element's points.
  static void gather(const Tet4Elements::Forces* points, Vec3* f);
  /// Computes T_qᵀK T_q summed over the element's points, one block per pair of nodes a < b in the order of
  /// Connectivity::pair_index.
  static void gather(const Tet4Elements::Stiffness* points, Mat3* K);
  /// Ratios of squared gradients at rest: of the nodes' shape functions, g_n, to those of the corners,
  /// Σ|b_c|². The first is Σ over points and nodes of |g_n|², the second Σ over nodes of |Σ over points of
  /// g_n|².
  static const double squares_of_points, squares_of_sums;
  /// Computes the gradients of the nodes' shape functions from those of the points' corners (transposes of
  /// D): r[40].
  static void spread(const CorotatedVector* corners, CorotatedVector* r);

 private:
  Tet4Elements corners_;
  std::vector<Nodes> nodes_;
  VecX volume_, shape_volume_;
};

}  // namespace prosector
