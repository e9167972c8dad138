#include "server/accuracy/law_difference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/assert.h"

namespace prosector {
namespace {

constexpr std::size_t most_points = 4;
constexpr int most_corrections = 8;
constexpr double largest_correction = 0.1, precise = 1e-9;  // of a stretch: limit of a step, and tolerance
constexpr double probe = 1e-5;                              // of a stretch: step of the numerical derivative

/// Stress of tissue that is stretched by s beyond F.
struct Stretched {
  std::array<Mat3, most_points> P;  // Pa
  double pressure = 0;              // Pa: mean Cauchy stress times det F
};
Stretched stretched(const soft::ConstitutiveLaw& tissue, double mean, std::span<const Mat3> F, double s) {
  const std::size_t n = F.size();
  std::array<Mat3, most_points> G;
  std::array<double, most_points> theta, pressure;
  double all = 0;
  for (std::size_t q = 0; q < n; ++q) G[q] = s * F[q];
  tissue.dilatation(std::span(G).first(n), std::span(theta).first(n));
  for (std::size_t q = 0; q < n; ++q) all += theta[q] / static_cast<double>(n);
  pressure.fill(mean * all);
  Stretched out;
  tissue.stress(std::span(G).first(n), std::span(pressure).first(n), std::span(out.P).first(n));
  for (std::size_t q = 0; q < n; ++q)
    out.pressure += out.P[q].cwiseProduct(G[q]).sum() / (3 * s * s * s * static_cast<double>(n));
  return out;
}

}  // namespace

LawDifference law_difference(const soft::ConstitutiveLaw& tissue, double mean, const ElementStrain& strain) {
  const std::size_t n = strain.F.size();
  PROSECTOR_ASSERT(n > 0 && n <= most_points && strain.P.size() == n && strain.R.size() == n);
  double pressure = 0;
  for (std::size_t q = 0; q < n; ++q)
    pressure += strain.P[q].cwiseProduct(strain.F[q]).sum() / (3 * static_cast<double>(n));
  double s = 1;
  Stretched at = stretched(tissue, mean, strain.F, s);
  for (int i = 0; i < most_corrections; ++i) {
    const double slope = (stretched(tissue, mean, strain.F, s + probe).pressure - at.pressure) / probe;
    if (!(slope > 0)) break;
    const double step = std::clamp((pressure - at.pressure) / slope, -largest_correction, largest_correction);
    s += step;
    at = stretched(tissue, mean, strain.F, s);
    if (std::abs(step) < precise) break;
  }
  LawDifference out{.pressure = pressure, .stretch = std::log(s)};
  out.work = 3 * pressure * out.stretch;
  for (std::size_t q = 0; q < n; ++q) {
    const Mat3 difference =
        strain.P[q] - at.P[q] / (s * s);  // tissue's Cauchy stress as a first Piola stress over F
    out.work += difference.cwiseProduct(strain.F[q] - strain.R[q]).sum() / static_cast<double>(n);
    out.stress += strain.R[q].transpose() * difference / static_cast<double>(n);
  }
  return out;
}

double work_on_top(const LawDifference& now, const LawDifference& before, const Mat3& strain) {
  return (now.stress - before.stress).cwiseProduct(strain).sum() +
         3 * (now.pressure - before.pressure) * (now.stretch - before.stretch);
}

}  // namespace prosector
