#pragma once
// How tissue is stretched while it rests: what keeps an uncut organ in shape, and opens a cut.
//
// Growth theory (Rodriguez, Hoger & McCulloch 1994) splits a deformation gradient, F = Fe·Fg. Fg takes each
// piece of the rest shape to the shape that it would have by itself. Fe, which alone is stressed, takes that
// to where it is. At rest F = I, so Fe = V := Fg⁻¹. V is taken symmetric: a rotation in Fg stresses nothing.

#include <cstdint>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// V by place in the rest shape, constant in each tetrahedron of the mesh that it was found for. Whatever
/// later divides these tetrahedra, its parts inherit.
class RestStretch {
 public:
  /// Takes the mesh, and V of each tetrahedron: symmetric, positive definite.
  RestStretch(const TetMesh& mesh, std::vector<Mat3> stretch);

  /// Returns V of the tetrahedron that p (m) is in, or else is nearest to in its coordinates.
  const Mat3& at(const Vec3& p) const;
  /// Returns V of each tetrahedron that was given.
  const std::vector<Mat3>& stretch() const { return stretch_; }

 private:
  /// A tetrahedron by its barycentric coordinates.
  struct Place {
    std::uint32_t tet;
    Vec3 origin;
    Mat3 inverse;
    double least_coordinate(const Vec3& p) const;
  };
  std::size_t cell_of(const Vec3& p) const;
  void list(const TetMesh& mesh);

  std::vector<Mat3> stretch_;
  std::vector<Place> places_;
  Vec3 origin_ = Vec3::Zero();  // m, of the grid
  double cell_ = 1;             // m
  Eigen::Vector3i size_ = Eigen::Vector3i::Ones();
  std::vector<std::uint32_t> begin_, listed_;  // by cell: places whose boxes meet it
};

/// Returns the middle of a tetrahedron, m.
Vec3 middle_of(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet);

}  // namespace prosector
