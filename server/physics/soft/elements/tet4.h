#pragma once
// Linear tetrahedra: the element type that SoftBody is built of. Everything that knows the shape functions
// stands here; another element type is another such file.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/soft/base/mesh_edit.h"
#include "server/physics/soft/laws/constitutive_law.h"

namespace prosector {

/// Shape functions are linear, so one F and one P per element: F = Σ_a x_a b_aᵀ with b_a = ∇N_a at rest.
class Tet4Elements {
 public:
  static constexpr int nodes_per_element = 4;
  using Nodes = std::array<std::uint32_t, nodes_per_element>;
  using Forces = std::array<Vec3, nodes_per_element>;
  /// The element's stiffness by pairs of nodes a < b, in the order of pair_index. Moving as a whole strains
  /// nothing, so each row sums to zero and the diagonal blocks need not be stored.
  using Stiffness = std::array<Mat3, nodes_per_element*(nodes_per_element - 1) / 2>;
  /// Returns the index of the pair a < b in Stiffness.
  static constexpr int pair_index(int a, int b) { return a * (5 - a) / 2 + b - 1; }

  /// Takes the elements that can strain: a tetrahedron flatter than `least_quality` or of no volume would
  /// only bring 1/0 and is left out (its mass is not, see lumped_volume). An element's nodes are sorted: F
  /// and V don't depend on their order, and no block needs to be transposed to find its place in a matrix.
  /// Node indices must be in range.
  explicit Tet4Elements(const TetMesh& mesh);
  /// Returns each element these `parts` times, with corners of its own and an equal share of the volume.
  static Tet4Elements parted(const Tet4Elements& elements, std::size_t parts);

  std::size_t size() const { return nodes_.size(); }
  std::size_t dropped() const { return dropped_; }
  const Nodes& nodes(std::size_t e) const { return nodes_[e]; }
  /// Returns, by element, which of the mesh's tetrahedra it is.
  std::span<const std::uint32_t> source() const { return source_; }
  double volume(std::size_t e) const { return volume_[e]; }  // m³, at rest, or where nothing stretches it

  /// Tells whether these are the elements of the mesh that was edited, none of which was left out, and it has
  /// none to leave out now. `rest`: 3n, m, before.
  bool can_follow(const VecX& rest, const MeshEdit& edit) const;
  /// Follows `mesh`, which was edited so.
  void follow(const TetMesh& mesh, const MeshEdit& edit);
  /// Follows the elements that these are parted from, which have followed.
  void follow_parted(const Tet4Elements& elements, const MeshEdit& edit);

  /// Columns b_1, b_2, b_3; b_0 = −(b_1 + b_2 + b_3). Of tissue under tension at rest V·b_a, with which F
  /// above is Fe (rest_stretch.h).
  const Mat3& gradients(std::size_t e) const { return gradients_[e]; }
  /// Columns x_a − x_0 at node positions x (3n).
  Mat3 edges(std::size_t e, const double* x) const;
  /// Computes V·P·b_a: the gradient of the element's energy.
  void forces(std::size_t e, const Mat3& P, Forces& f) const;
  /// Computes V·b_aᵀ·(∂P/∂F)·b_b for a < b.
  void stiffness(std::size_t e, const Mat9& dPdF, Stiffness& K) const;

  /// Returns m³ of each node: a quarter of every tetrahedron around it, dropped ones included. Times the
  /// density this is the lumped mass.
  static VecX lumped_volume(const TetMesh& mesh);
  /// Returns a node's share of a tetrahedron, m³.
  static double lumped_share(const TetMesh& mesh, std::size_t tet);

  /// 6V over the cube of the longest edge; 0.71 for the regular tetrahedron.
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
