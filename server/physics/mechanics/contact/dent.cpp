#include "server/physics/mechanics/contact/dent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace prosector::contact {
namespace {

/// Displacement of a mesh under a load, times E*·element_size/F: factor·spread^exponent. Linear elements lock
/// from a Poisson's ratio of 0.4 on. Fitted to Hertz's pressures on half-spaces, see
/// docs/look-up/contact-figures.md.
struct Yield {
  double poisson_ratio, factor, exponent;
};
constexpr std::array<Yield, 8> yields = {{{0, 0.90, 0.5},
                                          {0.3, 0.94, 0.5},
                                          {0.4, 0.912, 0.5},
                                          {0.45, 0.823, 0.472},
                                          {0.47, 0.750, 0.451},
                                          {0.49, 0.535, 0.350},
                                          {0.495, 0.417, 0.335},
                                          {0.499, 0.202, 0.219}}};

/// Returns the row for that Poisson's ratio, interpolated linearly.
Yield yield_at(double poisson_ratio) {
  const double nu = std::clamp(poisson_ratio, yields.front().poisson_ratio, yields.back().poisson_ratio);
  const auto above = std::find_if(yields.begin() + 1, yields.end() - 1,
                                  [&](const Yield& row) { return row.poisson_ratio >= nu; });
  const Yield &a = *(above - 1), &b = *above;
  const double t = (nu - a.poisson_ratio) / (b.poisson_ratio - a.poisson_ratio);
  return {nu, std::lerp(a.factor, b.factor, t), std::lerp(a.exponent, b.exponent, t)};
}

constexpr double least_patch = 0.05;       // fraction of the length
constexpr double mean_of_hertz = 4.0 / 5;  // mean displacement over the ball's
constexpr double most_even = 0.6961;       // fraction of the length at which both formulas agree
constexpr double least_share = 0.02;       // of the contact in the depth

}  // namespace

double contact_radius(double force, double radius, double modulus) {
  return std::cbrt(3 * force * radius / (4 * modulus));
}

double dent_length(double element_size, double spread, double poisson_ratio) {
  const Yield mesh = yield_at(poisson_ratio);
  return 3 * element_size / (4 * mesh.factor * std::pow(spread, mesh.exponent));
}

double dent_stiffness(double patch, double length) {
  const double a = std::max(patch, least_patch * length), share = a / length;
  if (share < most_even) return 4 / (3 * std::numbers::pi * a * (1 - share) * (1 - share));
  return 3 / (2 * std::numbers::pi * a * std::max(mean_of_hertz - share, least_share));
}

}  // namespace prosector::contact
