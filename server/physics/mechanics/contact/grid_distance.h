#pragma once
// A mesh's signed distance, sampled once on a grid and interpolated.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/contact/signed_distance.h"

namespace prosector {

/// Signed distance to a triangle mesh, sampled on a grid. Samples within a band of some cells around the
/// surface are exact. Samples beyond the band are a lower bound. The sign is the majority of ray parities
/// along the three axes, so small holes do no harm. Interpolation is trilinear; the normal is the
/// interpolant's gradient.
class GridDistance final : public SignedDistance {
 public:
  explicit GridDistance(const TriangleMesh& mesh);
  Distance at(const Vec3& x) const override;
  double cell() const { return cell_; }

 private:
  using Index3 = std::array<int, 3>;
  std::size_t index(int i, int j, int k) const;
  void splat(const TriangleMesh& mesh);
  void sign(const TriangleMesh& mesh);

  Vec3 origin_;
  double cell_;  // m
  Index3 size_;  // number of samples per axis
  std::vector<float> samples_;
};

}  // namespace prosector
