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

namespace prosector {

/// Linear tetrahedra with one F and one P per element: F = Σ_a x_a b_aᵀ with b_a = ∇N_a at rest.
class Tet4Elements {
 public:
  static constexpr int nodes_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  using Forces = std::array<Vec3, nodes_per_element>;
  /// The element's stiffness by pairs of nodes a < b, in the order of pair_index. A rigid translation causes
  /// no strain, so each row sums to zero and diagonal blocks are not stored.
  using Stiffness = std::array<Mat3, nodes_per_element*(nodes_per_element - 1) / 2>;
  /// Returns the index of the pair a < b in Stiffness.
  static constexpr int pair_index(int a, int b) { return a * (5 - a) / 2 + b - 1; }

  /// Creates the elements of `mesh`. A tetrahedron flatter than `least_quality`, or without volume, would
  /// cause divisions by zero and is left out; its mass is kept, see lumped_volume. Node indices must be in
  /// range.
  ///
  /// An element's nodes are sorted: F and V do not depend on their order, and no block needs to be transposed
  /// for its place in a matrix.
  explicit Tet4Elements(const TetMesh& mesh);
  /// Returns `parts` copies of each element, without common corners and with equal shares of the volume.
  static Tet4Elements parted(const Tet4Elements& elements, std::size_t parts);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return dropped_; }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns, by element, the index of its tetrahedron in the mesh.
  std::span<const std::uint32_t> source() const { return source_; }
  double volume(std::size_t e) const { return volume_[e]; }  // m³, at rest; with prestretch: stress-free

  /// Returns whether follow() can apply the edit: these are all elements of the mesh before the edit, and
  /// none must be left out after it. `rest`: 3n, m, before the edit.
  bool can_follow(const VecX& rest, const MeshEdit& edit) const;
  /// Updates the elements to the edited `mesh`.
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  /// Updates copies made by parted() after `elements` followed the edit.
  void follow_parted(const Tet4Elements& elements, const MeshEdit& edit);

  /// Returns the columns b_1, b_2, b_3; b_0 = −(b_1 + b_2 + b_3). For prestretched tissue they are V·b_a,
  /// with which F above becomes Fe (rest_stretch.h).
  const Mat3& gradients(std::size_t e) const { return gradients_[e]; }
  /// Returns the columns x_a − x_0 at node positions x (3n).
  Mat3 edges(std::size_t e, const double* x) const;
  /// Computes V·P·b_a: the gradient of the element's energy.
  void forces(std::size_t e, const Mat3& P, Forces& f) const;
  /// Computes V·b_aᵀ·(∂P/∂F)·b_b for a < b.
  void stiffness(std::size_t e, const Mat9& dPdF, Stiffness& K) const;

  /// Returns the volume of each node, m³: a quarter of each tetrahedron at the node, dropped ones included.
  /// Times the density, it is the lumped mass.
  static VecX lumped_volume(const TetMesh& mesh);
  /// Returns the share of one node in a tetrahedron, m³.
  static double lumped_share(const TetMesh& mesh, std::size_t tet);

  /// Limit of 6V over the cube of the longest edge; a regular tetrahedron has 0.71.
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

}  // namespace prosector
