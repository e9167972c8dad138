#include "server/physics/organs/locate.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double rounding = 1e-9;  // of a barycentric weight

std::optional<SparseMap::Row> weights_in(const std::array<std::uint32_t, 4>& tet, const VecX& x,
                                         const Vec3& point) {
  const auto at = [&](std::size_t k) -> Vec3 { return x.segment<3>(3 * Eigen::Index{tet[k]}); };
  const Vec3 origin = at(0);
  Mat3 edges;
  edges << at(1) - origin, at(2) - origin, at(3) - origin;
  if (!(edges.determinant() > 0)) return std::nullopt;
  const Vec3 w = edges.inverse() * (point - origin);
  if (!(w.minCoeff() >= -rounding) || !(w.sum() <= 1 + rounding)) return std::nullopt;
  return SparseMap::Row{tet, {1 - w.sum(), w[0], w[1], w[2]}};
}

}  // namespace

std::optional<SparseMap::Row> locate(const TetMesh& mesh, const VecX& x, const Vec3& point) {
  for (const auto& tet : mesh.tets) {
    // Most are told apart by one coordinate.
    bool beside = false;
    for (Eigen::Index axis = 0; axis < 3 && !beside; ++axis) {
      double lo = x[3 * Eigen::Index{tet[0]} + axis], hi = lo;
      for (std::size_t k = 1; k < 4; ++k) {
        lo = std::min(lo, x[3 * Eigen::Index{tet[k]} + axis]);
        hi = std::max(hi, x[3 * Eigen::Index{tet[k]} + axis]);
      }
      beside = point[axis] < lo || point[axis] > hi;
    }
    if (beside) continue;
    if (const auto row = weights_in(tet, x, point)) return row;
  }
  return std::nullopt;
}

}  // namespace prosector
