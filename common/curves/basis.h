#pragma once
// B-spline basis functions over a knot vector (Piegl & Tiller, The NURBS Book, 2nd ed. 1997, ch. 2).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace prosector {

inline constexpr int max_degree = 9;

using BasisRow = std::array<double, max_degree + 1>;  // of the degree + 1 functions that aren't zero

/// Returns knots that are clamped and uniform over 0 … 1, so that the curve meets its ends.
std::vector<double> clamped_knots(std::size_t points, int degree);
/// Returns zeros, then ones: with these knots a B-spline is a Bézier curve.
std::vector<double> bezier_knots(int degree);

/// Throws InputError unless there are points + degree + 1 finite knots, none below the one before. At most
/// `degree` of them may be equal but at the ends. The domain, from knot `degree` to knot `points`, must have
/// a length.
void check_knots(std::span<const double> knots, std::size_t points, int degree);

/// Finds the knot span that `u` lies in, among those with a length (A2.1).
std::size_t find_span(std::span<const double> knots, std::size_t points, int degree, double u);

/// N and its first and second derivative by u, of functions span − degree … span (A2.3).
struct BasisDerivatives {
  std::array<BasisRow, 3> order{};
};
BasisDerivatives basis_derivatives(std::span<const double> knots, std::size_t span, int degree, double u);

}  // namespace prosector
