#pragma once
// B-spline basis functions over a knot vector (Piegl & Tiller, The NURBS Book, 2nd ed. 1997, ch. 2).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace prosector {

inline constexpr int max_degree = 9;

using BasisRow = std::array<double, max_degree + 1>;  // of the degree + 1 functions that aren't zero

/// Clamped and uniform over 0 … 1, so that the ends are met.
std::vector<double> clamped_knots(std::size_t points, int degree);
/// Zeros, then ones: with it a B-spline is a Bézier curve.
std::vector<double> bezier_knots(int degree);

/// Throws InputError unless there are points + degree + 1 finite knots, none below the one before, at most
/// `degree` of them equal but at the ends, and the domain, from knot `degree` to knot `points`, has a length.
void check_knots(std::span<const double> knots, std::size_t points, int degree);

/// The knot span that `u` lies in, of those with a length (A2.1).
std::size_t find_span(std::span<const double> knots, std::size_t points, int degree, double u);

/// N and its first and second derivative by u, of functions span − degree … span (A2.3).
struct BasisDerivatives {
  std::array<BasisRow, 3> order{};
};
BasisDerivatives basis_derivatives(std::span<const double> knots, std::size_t span, int degree, double u);

}  // namespace prosector
