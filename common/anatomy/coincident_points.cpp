#include "common/anatomy/coincident_points.h"

#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace prosector {
namespace {

/// Representative points, by the cells of a grid.
class PointGrid {
 public:
  PointGrid(std::span<const Vec3> points, double tolerance)
      : points_(points), tolerance_(tolerance), step_(256 * tolerance) {
    for (const Vec3& x : points) corner_ = corner_.cwiseMin(x);
  }

  /// Returns the first added point within the tolerance of the given one; if there is none, the given one.
  std::uint32_t find(std::uint32_t number) const {
    const Vec3& x = points_[number];
    std::uint32_t best = number;
    const std::array<double, 3> low = cell(x - Vec3::Constant(tolerance_)),
                                high = cell(x + Vec3::Constant(tolerance_));
    for (double i = low[0]; i <= high[0]; ++i)
      for (double j = low[1]; j <= high[1]; ++j)
        for (double k = low[2]; k <= high[2]; ++k)
          if (const auto it = cells_.find(key({i, j, k})); it != cells_.end())
            for (const std::uint32_t p : it->second)
              if (p < best && (points_[p] - x).norm() <= tolerance_) best = p;
    return best;
  }
  void add(std::uint32_t number) { cells_[key(cell(points_[number]))].push_back(number); }

 private:
  std::array<double, 3> cell(const Vec3& x) const {
    const Vec3 steps = (x - corner_) / step_;
    return {std::floor(steps[0]), std::floor(steps[1]), std::floor(steps[2])};
  }
  /// Cells may share a key; the tolerance test then rejects the points of other cells.
  static std::uint64_t key(const std::array<double, 3>& cell) {
    std::uint64_t out = 0;
    for (const double c : cell)
      out = (out ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(c))) * 0x9e3779b97f4a7c15u;
    return out;
  }

  std::span<const Vec3> points_;
  Vec3 corner_ = Vec3::Constant(std::numeric_limits<double>::max());  // origin of the cells
  double tolerance_, step_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace

double extent_of(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : points) box.extend(x);
  return points.empty() ? 0 : box.sizes().maxCoeff();
}

std::vector<std::uint32_t> coincident_points(std::span<const Vec3> points, double tolerance) {
  std::vector<std::uint32_t> out(points.size());
  PointGrid grid(points, tolerance);
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    out[p] = tolerance > 0 ? grid.find(p) : p;
    if (tolerance > 0 && out[p] == p) grid.add(p);
  }
  return out;
}

}  // namespace prosector
