#include "server/physics/mechanics/organs/locate.h"

#include <algorithm>

#include "server/physics/base/parallel.h"

namespace prosector::organs {
namespace {

constexpr double rounding = 1e-9;  // of a barycentric weight
constexpr std::size_t tets_per_chunk = 2048;

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

Locator::Locator(const TetMesh& mesh, const VecX& x, const collision::Aabb& box) : mesh_(&mesh), x_(&x) {
  std::vector<std::vector<Near>> runs(chunk_count(mesh.tets.size(), tets_per_chunk));
  parallel_chunks(
      mesh.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t chunk) {
        for (std::size_t t = first; t < last; ++t) {
          Near near;
          near.tet = static_cast<std::uint32_t>(t);
          bool beside = false;  // one coordinate excludes most tetrahedra
          for (Eigen::Index axis = 0; axis < 3 && !beside; ++axis) {
            const auto at = [&](std::size_t k) { return x[3 * Eigen::Index{mesh.tets[t][k]} + axis]; };
            near.box.lo[axis] = std::min({at(0), at(1), at(2), at(3)});
            near.box.hi[axis] = std::max({at(0), at(1), at(2), at(3)});
            beside = near.box.lo[axis] > box.hi[axis] || near.box.hi[axis] < box.lo[axis];
          }
          if (beside) continue;
          const Vec3 room = 2 * rounding * (near.box.hi - near.box.lo);
          near.box = {near.box.lo - room, near.box.hi + room};
          runs[chunk].push_back(near);
        }
      });
  for (const std::vector<Near>& run : runs) near_.insert(near_.end(), run.begin(), run.end());
}

std::optional<SparseMap::Row> Locator::at(const Vec3& point) const {
  for (const Near& near : near_) {
    if ((point.array() < near.box.lo.array()).any() || (point.array() > near.box.hi.array()).any()) continue;
    if (const auto row = weights_in(mesh_->tets[near.tet], *x_, point)) return row;
  }
  return std::nullopt;
}

}  // namespace prosector::organs
