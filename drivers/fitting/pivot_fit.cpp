#include "drivers/fitting/pivot_fit.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "common/error.h"

namespace prosector {

PivotFit fit_pivot(std::span<const Pose> poses) {
  if (poses.size() < min_pivot_poses)
    throw InputError(
        fmt::format("{} poses of the instrument were measured: at least {} are needed, 200 are better",
                    poses.size(), min_pivot_poses));
  PivotFit fit;
  fit.poses = poses.size();
  const auto n = static_cast<double>(poses.size());
  Mat3 turns = Mat3::Zero();
  Vec3 places = Vec3::Zero(), right = Vec3::Zero();
  for (const Pose& x : poses) {
    turns += x.q.toRotationMatrix();
    places += x.p;
    right -= x.q.conjugate() * x.p;
  }
  // Eliminates the pivot: c = (ΣR t + Σp)/N.
  const Mat3 normal = n * Mat3::Identity() - turns.transpose() * turns / n;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(normal);
  const double least = std::max(solver.eigenvalues().minCoeff() / n, 0.0);
  fit.turn = std::asin(std::min(std::sqrt(least), 1.0));
  constexpr double degrees = 180 / std::numbers::pi;
  if (fit.turn < min_pivot_rotation)
    throw InputError(
        fmt::format("the instrument was rotated by only {:.1f}° in one direction ({:.1f}° are needed): rest "
                    "its tip and swing it in a cone of ±30° in all directions",
                    degrees * fit.turn, degrees * min_pivot_rotation));
  fit.tip = normal.ldlt().solve(right + turns.transpose() * places / n);
  fit.pivot = (turns * fit.tip + places) / n;
  double squares = 0;
  for (const Pose& x : poses) squares += (x * fit.tip - fit.pivot).squaredNorm();
  fit.residual = std::sqrt(squares / n);
  if (fit.residual > max_pivot_residual)
    throw InputError(
        fmt::format("the tip deviated from its pivot by {:.1f} mm RMS (at most {:.0f} mm): it slipped, or "
                    "the receiver moves relative to the instrument",
                    1e3 * fit.residual, 1e3 * max_pivot_residual));
  const double variance = squares / (3 * n - 6);
  fit.tip_error = std::sqrt(variance * solver.eigenvalues().cwiseInverse().sum());
  return fit;
}

}  // namespace prosector
