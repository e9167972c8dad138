#pragma once
// A mesh's signed distance, sampled once on a grid and interpolated.

#include <array>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/contact/signed_distance.h"

namespace prosector::contact {

/// Signed distance to a triangle mesh, sampled on a grid and interpolated trilinearly; the normal is the
/// interpolant's gradient. Samples within a few cells of the surface are exact, samples farther away are a
/// lower bound. Inside and outside are decided by the majority of ray parities along the three axes, so that
/// small holes have no effect.
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

}  // namespace prosector::contact
