#pragma once
// The equations of a spline in space with a polynomial: what bends least of all that fit (Duchon 1977).
//
//   [K + δI, P; Pᵀ, 0] [w; a] = [y; 0],   K_ij = φ(|x_i − x_j|)
//
// P has the polynomials' values at the nodes. A δ other than 0 smooths.

#include <Eigen/LU>
#include <span>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A spline at its nodes. The first rows of `solution` are weights of nodes, then the polynomials' follow.
struct SplineSolution {
  Eigen::MatrixXd solution;
  double log_determinant = 0;  // of the equations' matrix, by its magnitude
};

/// Solves for values y at scaled nodes, a row each. `kernel` is φ of a distance.
SplineSolution solve_spline(std::span<const Vec3> nodes, const Eigen::MatrixXd& polynomials,
                            double (*kernel)(double), double diagonal, const Eigen::MatrixXd& values);

}  // namespace prosector
