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

std::vector<std::optional<SparseMap::Row>> locate(const TetMesh& mesh, const VecX& x,
                                                  std::span<const Vec3> points) {
  std::vector<std::optional<SparseMap::Row>> out(points.size());
  if (points.empty()) return out;
  Vec3 low = points.front(), high = low;
  for (const Vec3& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (const auto& tet : mesh.tets) {
    // Most are told apart by one coordinate.
    bool beside = false;
    for (Eigen::Index axis = 0; axis < 3 && !beside; ++axis) {
      const auto at = [&](std::size_t k) { return x[3 * Eigen::Index{tet[k]} + axis]; };
      beside = std::min({at(0), at(1), at(2), at(3)}) > high[axis] ||
               std::max({at(0), at(1), at(2), at(3)}) < low[axis];
    }
    if (beside) continue;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (!out[p]) out[p] = weights_in(tet, x, points[p]);
  }
  return out;
}

}  // namespace prosector
