#pragma once
// Quadratic tetrahedra of ten nodes, straight-sided at rest: vertices and the middles of the edges.
//
// With L_c the barycentric coordinates and D_c = ∂x/∂L_c (quadratic fields: linear in L),
//   F = Σ_c D_c g_cᵀ,  g_c = ∇L_c at rest,  D_c = (4L_c − 1)·x_c + 4·Σ_{d≠c} L_d x_cd.
// So each integration point is a linear tetrahedron whose corners are at D_c. What is known for those
// (tet4.h, element_batches.h) holds at the points. T_q, which takes nodes to the D_c of point q, gives forces
// T_qᵀf and stiffness T_qᵀK T_q. Four points integrate stiffness exactly where the law is linear.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/soft/base/connectivity.h"
#include "server/physics/soft/elements/edge_nodes.h"
#include "server/physics/soft/elements/tet4.h"
#include "server/physics/soft/elements/turned_elements.h"

namespace prosector {

class Tet10Elements {
 public:
  static constexpr std::size_t nodes_per_element = 10, points_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  /// The vertices of edge node 4 + k.
  static constexpr auto& edge = EdgeNodes::edges_of_tet;

  /// Makes the elements of `mesh`, which has its edges' nodes already, see add_edge_nodes. Elements too flat
  /// to strain are left out as in tet4.h. Each element's nodes ascend: its vertices, then its edges.
  explicit Tet10Elements(const TetMesh& mesh);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return corners_.dropped(); }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns which of the mesh's tetrahedra the element is.
  std::uint32_t source(std::size_t e) const { return corners_.source()[e]; }
  /// Returns, by integration point, which of the mesh's tetrahedra it is in.
  std::vector<std::uint32_t> point_source() const;
  /// Returns m³ of each node, dropped elements included: the diagonal of the mass matrix scaled to the right
  /// total (Hinton, Rock, Zienkiewicz 1976): V/36 at vertices, 4V/27 at edges. Positive, and the better half
  /// of the consistent one; rows summed would be negative at vertices.
  const VecX& lumped_volume() const { return volume_; }
  /// Returns m³ of each node by the integrals of the shape functions: −V/20 at vertices, V/5 at edges.
  const VecX& shape_volume() const { return shape_volume_; }

  /// Returns the integration points as linear tetrahedra with four corners of their own each, a quarter of
  /// the element's volume: points 4e … 4e + 3 are those of element e.
  Tet4Elements points() const { return Tet4Elements::parted(corners_, points_per_element); }

  /// Returns the elements as linear tetrahedra.
  const Tet4Elements& corners() const { return corners_; }

  // ---- Following a cut
  /// Tells whether the elements can follow the edit, see tet4.h. `corners`: the edit of the vertices.
  bool can_follow(const VecX& rest, const MeshEdit& corners) const {
    return corners_.can_follow(rest, corners);
  }
  /// Follows `mesh`, which was edited so, the nodes on its edges included; but for the volume, which elements
  /// and incidence as they are now tell.
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  void follow_volume(const TetMesh& mesh, const MeshEdit& edit, const Connectivity& connectivity,
                     const Incidence& incidence);

  /// Computes D_c of the four points of element e at node positions x (3n), 3 per corner: to[48].
  void move(std::size_t e, const double* x, double* to) const;
  /// Computes T_qᵀf summed over the element's points.
  static void gather(const Tet4Elements::Forces* points, Vec3* f);
  /// Computes T_qᵀK T_q summed over the element's points, one block per pair of nodes a < b in the order of
  /// Connectivity::pair_index.
  static void gather(const Tet4Elements::Stiffness* points, Mat3* K);
  /// Squares of the nodes' shape functions' gradients g_n at a point over those of its corners, Σ|b_c|². They
  /// are Σ over points and nodes of |g_n|², and Σ over nodes of |Σ over points of g_n|².
  static const double squares_of_points, squares_of_sums;
  /// Gradients of the nodes' shape functions from those of the points' corners (D's transposes): r[40].
  static void spread(const TurnedVector* corners, TurnedVector* r);

 private:
  Tet4Elements corners_;
  std::vector<Nodes> nodes_;
  VecX volume_, shape_volume_;
};

}  // namespace prosector
