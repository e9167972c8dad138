#pragma once
// A mesh's signed distance, sampled on a grid once and interpolated.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/contact/signed_distance.h"

namespace prosector {

/// The signed distance to triangles, sampled on a grid. Distances are exact to the triangles within a band of
/// some cells around the surface and a lower bound beyond it. The sign is a majority of ray parities along
/// the three axes, so small holes do no harm. Between samples: trilinear, with the gradient of the
/// interpolant as the normal.
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
  Index3 size_;  // samples
  std::vector<float> samples_;
};

}  // namespace prosector
