#pragma once
// B-spline basis functions over a knot vector (Piegl & Tiller, The NURBS Book, 2nd ed. 1997, ch. 2).

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace prosector {

inline constexpr int max_degree = 9;

using BasisRow = std::array<double, max_degree + 1>;  // values of the degree + 1 non-zero basis functions

/// Returns a clamped, uniform knot vector over 0 … 1 for a B-spline with `points` control points. Its curve
/// interpolates the first and last control point.
std::vector<double> clamped_knots(std::size_t points, int degree);
/// Returns the knot vector 0 … 0, 1 … 1 (degree + 1 of each), for which a B-spline is a Bézier curve.
std::vector<double> bezier_knots(int degree);

/// Checks a knot vector. Throws InputError unless there are points + degree + 1 finite, non-decreasing knots.
/// Inner knots may repeat at most `degree` times, the end knots degree + 1 times. The domain, from knot
/// `degree` to knot `points`, must have a positive length.
void check_knots(std::span<const double> knots, std::size_t points, int degree);

/// Returns the index i of the non-empty knot span [knot i, knot i + 1] that contains `u` (algorithm A2.1 of
/// The NURBS Book).
std::size_t find_span(std::span<const double> knots, std::size_t points, int degree, double u);

/// Values of the B-spline basis functions with indices span − degree … span at one parameter u, and their
/// first and second derivatives by u (algorithm A2.3 of The NURBS Book).
struct BasisDerivatives {
  std::array<BasisRow, 3> order{};
};
BasisDerivatives basis_derivatives(std::span<const double> knots, std::size_t span, int degree, double u);

}  // namespace prosector
