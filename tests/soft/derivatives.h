#pragma once
// A body's gradient and Hessian against finite differences of its energy.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

/// Numbers in [−1, 1].
inline VecX random_vector(Eigen::Index n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return VecX::NullaryExpr(n, [&] { return std::uniform_real_distribution<double>(-1, 1)(random); });
}

/// Along dx at x, within a stage that was begun, where no element's Hessian needs projecting. Leaves the
/// matrix assembled at x.
inline void expect_derivatives_of_energy(soft::IncrementalPotential& potential, const VecX& x,
                                         const VecX& dx) {
  VecX g(x.size()), g_plus(x.size()), g_minus(x.size()), Hdx(x.size());
  const double e = 1e-7;
  potential.gradient(x, g);
  const double slope = (potential.energy(x + e * dx) - potential.energy(x - e * dx)) / (2 * e);
  EXPECT_NEAR(g.dot(dx), slope, 1e-6 * std::abs(slope));
  potential.gradient(x + e * dx, g_plus);
  potential.gradient(x - e * dx, g_minus);
  potential.assemble(x);
  potential.multiply(dx.data(), Hdx.data());
  EXPECT_LT((Hdx - (g_plus - g_minus) / (2 * e)).norm(), 1e-5 * Hdx.norm());
}

}  // namespace prosector
