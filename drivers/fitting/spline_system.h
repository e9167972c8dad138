#pragma once
// Linear system of a spline in space plus a polynomial: of all functions that fit, the one with the least
// bending energy (Duchon 1977).
//
//   [K + δI, P; Pᵀ, 0] [w; a] = [y; 0],   K_ij = φ(|x_i − x_j|)
//
// P holds the polynomials' values at the nodes. A non-zero δ smooths.

#include <Eigen/LU>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Coefficients of a spline plus a polynomial. `solution` has one row per node weight, followed by the
/// polynomial's coefficients, and one column per interpolated value.
struct SplineSolution {
  Eigen::MatrixXd solution;
  double log_determinant = 0;  // log of the absolute determinant of the system's matrix
};

/// Solves for the coefficients of a spline plus a polynomial that takes `values` (one row per node) at scaled
/// nodes. `polynomials` holds the polynomial terms at each node (rows). `kernel` is the spline's function of
/// distance. `diagonal` is 0 for interpolation; larger values smooth.
SplineSolution solve_spline(std::span<const Vec3> nodes, const Eigen::MatrixXd& polynomials,
                            double (*kernel)(double), double diagonal, const Eigen::MatrixXd& values);

}  // namespace prosector
