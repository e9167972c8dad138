#include "server/physics/mechanics/contact/grid_distance.h"

#include <algorithm>
#include <cmath>

#include "server/physics/mechanics/collision/primitives/closest_points.h"

namespace prosector::contact {
namespace {

// 1/m: curvature reported for meshes, which is unknown; not 0, since 0 means flat.
constexpr double untold_curvature = 1e-3;

constexpr int cells_along_longest = 40;
constexpr int band = 4;  // cells: half width of the band with exact distances, and padding of the grid

}  // namespace

GridDistance::GridDistance(const TriangleMesh& mesh) {
  Vec3 lo = mesh.positions.front(), hi = lo;
  for (const Vec3& p : mesh.positions) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  cell_ = std::max((hi - lo).maxCoeff() / cells_along_longest, 1e-6);
  origin_ = lo - Vec3::Constant(band * cell_);
  for (int axis = 0; axis < 3; ++axis)
    size_[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::ceil((hi[axis] - lo[axis]) / cell_)) + 2 * band + 1;
  samples_.assign(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                      static_cast<std::size_t>(size_[2]),
                  static_cast<float>(band * cell_));
  splat(mesh);
  sign(mesh);
}

std::size_t GridDistance::index(int i, int j, int k) const {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(size_[0]) +
         static_cast<std::size_t>(i);
}

void GridDistance::splat(const TriangleMesh& mesh) {
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 lo = (a.cwiseMin(b).cwiseMin(c) - origin_) / cell_;
    const Vec3 hi = (a.cwiseMax(b).cwiseMax(c) - origin_) / cell_;
    Index3 first, last;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      first[axis] = std::max(0, static_cast<int>(std::floor(lo[at])) - band);
      last[axis] = std::min(size_[axis] - 1, static_cast<int>(std::ceil(hi[at])) + band);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) {
          const Vec3 p = origin_ + cell_ * Vec3(i, j, k);
          const Vec3 w = collision::closest_weights(p, a, b, c);
          const double d = (w[0] * a + w[1] * b + w[2] * c - p).norm();
          float& sample = samples_[index(i, j, k)];
          sample = std::min(sample, static_cast<float>(d));
        }
  }
}

void GridDistance::sign(const TriangleMesh& mesh) {
  std::vector<std::uint8_t> votes(samples_.size(), 0);
  std::vector<std::vector<double>> crossings;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto ai = static_cast<Eigen::Index>(axis), ui = static_cast<Eigen::Index>(u),
               vi = static_cast<Eigen::Index>(v);
    crossings.assign(static_cast<std::size_t>(size_[u]) * static_cast<std::size_t>(size_[v]), {});
    for (const auto& t : mesh.triangles) {
      std::array<Vec3, 3> x;
      for (std::size_t c = 0; c < 3; ++c) x[c] = (mesh.positions[t[c]] - origin_) / cell_;
      const auto range = [&](Eigen::Index i) {
        return std::pair{static_cast<int>(std::ceil(std::min({x[0][i], x[1][i], x[2][i]}))),
                         static_cast<int>(std::floor(std::max({x[0][i], x[1][i], x[2][i]})))};
      };
      const auto [u0, u1] = range(ui);
      const auto [v0, v1] = range(vi);
      for (int b = v0; b <= v1; ++b)
        for (int a = u0; a <= u1; ++a) {
          // Half-open edge rule: a ray through a shared edge crosses exactly one of its two triangles.
          const auto side = [&](const Vec3& p, const Vec3& q) {
            return (q[ui] - p[ui]) * (b - p[vi]) - (q[vi] - p[vi]) * (a - p[ui]);
          };
          const auto straddles = [&](const Vec3& p, const Vec3& q) { return (p[vi] <= b) != (q[vi] <= b); };
          int parity = 0;
          for (std::size_t e = 0; e < 3; ++e) {
            const Vec3 &p = x[e], &q = x[(e + 1) % 3];
            if (straddles(p, q) && (side(p, q) > 0) == (q[vi] > p[vi])) parity ^= 1;
          }
          const double area = side(x[0], x[1]) + side(x[1], x[2]) + side(x[2], x[0]);
          if (parity == 0 || area == 0) continue;
          const double depth =
              (side(x[1], x[2]) * x[0][ai] + side(x[2], x[0]) * x[1][ai] + side(x[0], x[1]) * x[2][ai]) /
              area;
          crossings[static_cast<std::size_t>(b) * static_cast<std::size_t>(size_[u]) +
                    static_cast<std::size_t>(a)]
              .push_back(depth);
        }
    }
    for (int b = 0; b < size_[v]; ++b)
      for (int a = 0; a < size_[u]; ++a) {
        auto& line = crossings[static_cast<std::size_t>(b) * static_cast<std::size_t>(size_[u]) +
                               static_cast<std::size_t>(a)];
        std::sort(line.begin(), line.end());
        std::size_t passed = 0;
        for (int s = 0; s < size_[axis]; ++s) {
          while (passed < line.size() && line[passed] < s) ++passed;
          Index3 at;
          at[axis] = s;
          at[u] = a;
          at[v] = b;
          if (passed % 2 == 1) ++votes[index(at[0], at[1], at[2])];
        }
      }
  }
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (votes[i] >= 2) samples_[i] = -samples_[i];
}

Distance GridDistance::at(const Vec3& x) const {
  Vec3 g = (x - origin_) / cell_;
  Vec3 inside;
  Index3 base;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    inside[i] = std::clamp(g[i], 0.0, static_cast<double>(size_[axis] - 1));
    base[axis] = std::min(static_cast<int>(inside[i]), size_[axis] - 2);
  }
  const Vec3 f = inside - Vec3(base[0], base[1], base[2]);
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const int di = corner & 1, dj = corner >> 1 & 1, dk = corner >> 2;
    const double s = samples_[index(base[0] + di, base[1] + dj, base[2] + dk)];
    const double wx = di ? f.x() : 1 - f.x(), wy = dj ? f.y() : 1 - f.y(), wz = dk ? f.z() : 1 - f.z();
    value += s * wx * wy * wz;
    gradient += s * Vec3((di ? 1 : -1) * wy * wz, (dj ? 1 : -1) * wx * wz, (dk ? 1 : -1) * wx * wy);
  }
  const double slope = gradient.norm();
  const double beyond = (g - inside).norm() * cell_;  // outside the grid: at least this far away
  return {value + beyond, slope > 0 ? Vec3(gradient / slope) : Vec3(Vec3::UnitY()), untold_curvature};
}

}  // namespace prosector::contact
