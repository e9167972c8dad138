#include "client/render/irradiance.h"

#include <array>
#include <numbers>

namespace prosector {
namespace {

/// Returns the real spherical harmonics of orders 0, 1 and 2, without their normalisation factors.
std::array<double, 9> harmonics(const Vec3& n) {
  return {1,
          n.x(),
          n.y(),
          n.z(),
          n.x() * n.y(),
          n.y() * n.z(),
          n.z() * n.x(),
          3 * n.y() * n.y() - 1,
          n.x() * n.x() - n.z() * n.z()};
}

// Squared normalisation factors times 4π: 1, 3, 15, 5/4, 15/4. Multiplied by each order's attenuation by the
// cosine lobe, over π: 1, 2/3, 1/4.
constexpr std::array<double, 9> weights = {1, 2, 2, 2, 15.0 / 4, 15.0 / 4, 15.0 / 4, 5.0 / 16, 15.0 / 16};

}  // namespace

std::vector<Vec3> irradiance_of(const std::vector<LightPatch>& around) {
  std::vector<Vec3> out(weights.size(), Vec3::Zero());
  for (const LightPatch& patch : around) {
    const std::array<double, 9> y = harmonics(patch.direction);
    const double share = patch.solid_angle / (4 * std::numbers::pi);
    for (std::size_t k = 0; k < out.size(); ++k) out[k] += weights[k] * share * y[k] * patch.radiance;
  }
  // Splits 3 y² − 1 into its two terms.
  out[0] -= out[7];
  out[7] *= 3;
  return out;
}

}  // namespace prosector
