#pragma once
// Linear tetrahedra. All code that depends on their shape functions is in this file; each other element type
// has a similar file.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"

namespace prosector::soft {

/// Linear tetrahedra. Each has one constant deformation gradient F = Σ_a x_a b_aᵀ, where x_a are its node
/// positions and b_a = ∇N_a the gradients of the shape functions at rest.
class Tet4Elements {
 public:
  static constexpr int nodes_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  using Forces = std::array<Vec3, nodes_per_element>;
  /// Stiffness of one linear tetrahedron: a 3×3 block for each pair of its nodes a < b, in the order of
  /// pair_index. A rigid translation causes no strain, so each row sums to zero and diagonal blocks are not
  /// stored.
  using Stiffness = std::array<Mat3, nodes_per_element*(nodes_per_element - 1) / 2>;
  /// Returns the index in Stiffness of the block for the pair of nodes a < b of a tetrahedron.
  static constexpr int pair_index(int a, int b) { return a * (5 - a) / 2 + b - 1; }

  /// Creates an element for each tetrahedron of `mesh`. A tetrahedron flatter than `least_quality`, or
  /// without volume, would cause divisions by zero and is left out; its mass is counted, see lumped_volume.
  /// Node indices must be in range.
  ///
  /// The nodes of an element are sorted. Its deformation gradient and volume do not depend on their order,
  /// and then no stiffness block needs to be transposed for its place in a matrix.
  explicit Tet4Elements(const TetMesh& mesh);
  /// Returns `parts` copies of each element, each with its share 1/`parts` of the volume and separate nodes.
  /// Used for the integration points of quadratic elements.
  static Tet4Elements parted(const Tet4Elements& elements, std::size_t parts);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return dropped_; }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns for each element the index of its tetrahedron in the mesh. Indices differ if flat tetrahedra
  /// were left out.
  std::span<const std::uint32_t> source() const { return source_; }
  double volume(std::size_t e) const { return volume_[e]; }  // m³, at rest; with prestretch: stress-free

  /// Returns whether follow() can apply the mesh edit: each tetrahedron of the mesh before the edit has an
  /// element, and none becomes too flat for one. `rest`: rest positions before the edit (3n, m).
  bool can_follow(const VecX& rest, const MeshEdit& edit) const;
  /// Updates the elements after `edit` changed the mesh to `mesh`. Requires can_follow().
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  /// Updates the copies that parted() made of `elements`, after `elements` were updated for the mesh edit.
  void follow_parted(const Tet4Elements& elements, const MeshEdit& edit);

  /// Returns the gradients b_1, b_2, b_3 of the shape functions of element e at rest, 1/m, as columns; b_0 =
  /// −(b_1 + b_2 + b_3). For prestretched tissue they are V·b_a with the prestretch V (3×3). Then F is the
  /// elastic deformation gradient from the stress-free shape.
  const Mat3& gradients(std::size_t e) const { return gradients_[e]; }
  /// Returns the edge vectors x_a − x_0, a = 1 … 3, of element e at node positions x (3n, m), as columns.
  Mat3 edges(std::size_t e, const double* x) const;
  /// Computes the gradient of the energy of element e with respect to its four node positions, f_a = V·P·b_a,
  /// N. V is its volume, P the first Piola stress (Pa), and b_a the gradient of shape function a.
  void forces(std::size_t e, const Mat3& P, Forces& f) const;
  /// Computes the stiffness blocks V·b_aᵀ·(∂P/∂F)·b_b, N/m, of element e for its pairs of nodes a < b. V is
  /// its volume, and b_a is the gradient of shape function a. `dPdF`: derivative of the first Piola stress by
  /// the deformation gradient, Pa, as a 9×9 matrix.
  void stiffness(std::size_t e, const Mat9& dPdF, Stiffness& K) const;

  /// Returns the volume of each node, n, m³: a quarter of each tetrahedron at the node, including those
  /// without an element. Times the density, it is the lumped mass.
  static VecX lumped_volume(const TetMesh& mesh);
  /// Returns the volume, m³, that each of its four nodes gets from the tetrahedron with index `tet`: a
  /// quarter of the tetrahedron's volume.
  static double lumped_share(const TetMesh& mesh, std::size_t tet);

  /// Minimum quality of a tetrahedron for which an element is created: 6 × volume / (longest edge)³. A
  /// regular tetrahedron has 0.71.
  static constexpr double least_quality = 1e-4;

 private:
  Tet4Elements() = default;
  void set(std::size_t e, const TetMesh& mesh);
  void set_stretch(std::size_t e, const Mat3& stretch);
  void resize(std::size_t size);
  void set_parts(std::size_t e, std::size_t parts, const Tet4Elements& elements);
  void drop_unusable();

  std::vector<Nodes> nodes_;
  std::vector<std::uint32_t> source_;
  std::vector<Mat3> gradients_;
  std::vector<double> volume_;
  std::size_t dropped_ = 0;
};

}  // namespace prosector::soft
