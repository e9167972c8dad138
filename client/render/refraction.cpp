#include "client/render/refraction.h"

namespace prosector {

Vec3 refractive_indices(const Appearance& glass) {
  // µm: Fraunhofer lines d, F and C, and the dominant wavelengths of IEC 61966-2-1's primaries.
  constexpr double d = 0.58756, F = 0.48613, C = 0.65627;
  const Vec3 primaries(0.6114, 0.5491, 0.4642);
  const double B = (glass.refractive_index - 1) / glass.abbe_number / (1 / (F * F) - 1 / (C * C));
  const double A = glass.refractive_index - B / (d * d);
  return (A + B / primaries.array().square()).matrix();
}

}  // namespace prosector
