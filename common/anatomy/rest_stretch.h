#pragma once
// Prestress of tissue: the elastic stretch at rest, which holds an uncut organ in shape and opens cuts.
//
// Growth theory (Rodriguez, Hoger & McCulloch 1994) splits the deformation gradient, F = Fe·Fg. Fg maps each
// piece of the rest shape to its stress-free shape. Fe, the elastic part, maps that to the current shape. At
// rest F = I, hence Fe = V := Fg⁻¹. V is symmetric, since a rotation in Fg causes no stress.

#include <cstdint>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Field of the elastic stretch V of prestressed tissue over its rest shape, constant in each tetrahedron of
/// the original mesh. Elements that later subdivide these tetrahedra inherit V.
class RestStretch {
 public:
  /// Stores the elastic stretch V of each tetrahedron of the mesh at rest. Each V is a symmetric, positive
  /// definite 3 × 3 matrix.
  RestStretch(const TetMesh& mesh, std::vector<Mat3> stretch);

  /// Returns the elastic stretch V of the tetrahedron that contains p (m, rest shape). If none does, returns
  /// that of the tetrahedron in which p's smallest barycentric coordinate is largest.
  const Mat3& at(const Vec3& p) const;
  /// Returns the elastic stretch V at rest of each tetrahedron of the mesh that the constructor was given.
  const std::vector<Mat3>& stretch() const { return stretch_; }

 private:
  /// A tetrahedron as an affine map from positions to its barycentric coordinates.
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
  Vec3 origin_ = Vec3::Zero();  // m: origin of the grid
  double cell_ = 1;             // m: grid spacing
  Eigen::Vector3i size_ = Eigen::Vector3i::Ones();
  std::vector<std::uint32_t> begin_, listed_;  // by grid cell: tetrahedra whose boxes intersect it
};

/// Returns the centroid (m) of a tetrahedron, given by four node indices of the mesh.
Vec3 middle_of(const TetMesh& mesh, const std::array<std::uint32_t, 4>& tet);

}  // namespace prosector
