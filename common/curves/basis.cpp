#include "common/curves/basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

/// Returns the basis functions of `degree` that are non-zero at u, starting at index span − degree (A2.2).
BasisRow basis(std::span<const double> knots, std::size_t span, int degree, double u) {
  BasisRow n{};
  BasisRow left{}, right{};
  n[0] = 1;
  for (std::size_t j = 1; j <= static_cast<std::size_t>(degree); ++j) {
    left[j] = u - knots[span + 1 - j];
    right[j] = knots[span + j] - u;
    double saved = 0;
    for (std::size_t r = 0; r < j; ++r) {
      const double share = n[r] / (right[r + 1] + left[j - r]);
      n[r] = saved + right[r + 1] * share;
      saved = left[j - r] * share;
    }
    n[j] = saved;
  }
  return n;
}

/// Returns the derivatives by u of the functions of `degree`, computed from those of degree − 1, `lower` (eq.
/// 2.7).
BasisRow differentiated(const BasisRow& lower, std::span<const double> knots, std::size_t span, int degree) {
  BasisRow out{};
  const auto p = static_cast<std::size_t>(degree);
  for (std::size_t k = 0; k <= p; ++k) {
    const std::size_t i = span - p + k;  // function N_i,p; lower[k − 1] is N_i,p−1, lower[k] is N_i+1,p−1
    if (k > 0 && knots[i + p] > knots[i]) out[k] += degree * lower[k - 1] / (knots[i + p] - knots[i]);
    if (k < p && knots[i + p + 1] > knots[i + 1])
      out[k] -= degree * lower[k] / (knots[i + p + 1] - knots[i + 1]);
  }
  return out;
}

}  // namespace

std::vector<double> clamped_knots(std::size_t points, int degree) {
  const auto p = static_cast<std::size_t>(degree);
  std::vector<double> knots(points + p + 1, 0.0);
  const std::size_t spans = points - p;
  for (std::size_t k = 0; k < knots.size(); ++k)
    knots[k] = k <= p ? 0 : std::min(1.0, static_cast<double>(k - p) / static_cast<double>(spans));
  return knots;
}

std::vector<double> bezier_knots(int degree) {
  return clamped_knots(static_cast<std::size_t>(degree) + 1, degree);
}

void check_knots(std::span<const double> knots, std::size_t points, int degree) {
  if (degree < 1 || degree > max_degree)
    throw InputError(fmt::format("degree {}: must be 1 to {}", degree, max_degree));
  const auto p = static_cast<std::size_t>(degree);
  if (points < p + 1)
    throw InputError(fmt::format("{} control points are too few for degree {}: it needs {} at least", points,
                                 degree, degree + 1));
  if (knots.size() != points + p + 1)
    throw InputError(fmt::format("{} knots are given, but a curve of {} points and degree {} needs {}",
                                 knots.size(), points, degree, points + p + 1));
  for (std::size_t k = 0; k < knots.size(); ++k) {
    if (!std::isfinite(knots[k])) throw InputError(fmt::format("knot {} is not a finite number", k + 1));
    if (k > 0 && knots[k] < knots[k - 1])
      throw InputError(
          fmt::format("knot {} is {}, which is below the knot before it, {}; knots must not decrease", k + 1,
                      knots[k], knots[k - 1]));
    // The first and the last degree + 1 knots may be equal.
    if (k > p && k + 1 < knots.size() && knots[k] == knots[k - p])
      throw InputError(fmt::format("knots {} to {} are all {}: at most {} within the curve may be equal",
                                   k - p + 1, k + 1, knots[k], degree));
  }
  if (!(knots[points] > knots[p]))
    throw InputError(
        fmt::format("knots {} to {} are all {}, so the curve has no length in u; they must differ", p + 1,
                    points + 1, knots[p]));
}

std::size_t find_span(std::span<const double> knots, std::size_t points, int degree, double u) {
  const auto first = knots.begin() + degree, last = knots.begin() + static_cast<std::ptrdiff_t>(points);
  // The last span that begins at or before u; at the domain's end, the last non-empty span.
  auto after = std::upper_bound(first, last, u);
  if (after == last) after = std::lower_bound(first, last, *last);
  return static_cast<std::size_t>(std::max(after - knots.begin(), first - knots.begin() + 1)) - 1;
}

BasisDerivatives basis_derivatives(std::span<const double> knots, std::size_t span, int degree, double u) {
  BasisDerivatives out;
  out.order[0] = basis(knots, span, degree, u);
  if (degree >= 1) out.order[1] = differentiated(basis(knots, span, degree - 1, u), knots, span, degree);
  if (degree >= 2) {
    // First differentiate the functions of degree − 1.
    const BasisRow lower = differentiated(basis(knots, span, degree - 2, u), knots, span, degree - 1);
    out.order[2] = differentiated(lower, knots, span, degree);
  }
  return out;
}

}  // namespace prosector
