#include "drivers/fitting/rigid_fit.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "common/error.h"

namespace prosector {
namespace {

/// Sets the centre, principal axes and spread of the points in the room.
void describe_spread(std::span<const TouchedPoint> points, RigidFit& fit) {
  const auto n = static_cast<double>(points.size());
  for (const TouchedPoint& p : points) fit.centre += p.room / n;
  Mat3 scatter = Mat3::Zero();
  for (const TouchedPoint& p : points)
    scatter += (p.room - fit.centre) * (p.room - fit.centre).transpose() / n;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(scatter);
  fit.axes = solver.eigenvectors();
  const Vec3 along = solver.eigenvalues().cwiseMax(0);
  for (int k = 0; k < 3; ++k) fit.spread[k] = std::sqrt(along.sum() - along[k]);
}

}  // namespace

double RigidFit::expected_error(const Vec3& target, double fle_m) const {
  const Vec3 from = axes.transpose() * (target - centre);
  double sum = 0;
  for (int k = 0; k < 3; ++k) sum += (from.squaredNorm() - from[k] * from[k]) / (spread[k] * spread[k]);
  return fle_m * std::sqrt((1 + sum / 3) / static_cast<double>(points));
}

RigidFit fit_rigid(std::span<const TouchedPoint> points) {
  if (points.size() < min_touched_points)
    throw InputError(fmt::format("{} points were touched: at least {} are needed, 6 are better",
                                 points.size(), min_touched_points));
  RigidFit fit;
  fit.points = points.size();
  describe_spread(points, fit);
  if (fit.spread.minCoeff() < min_point_spread)
    throw InputError(
        fmt::format("the points are within {:.0f} mm of one line, so the rotation about it is undetermined: "
                    "touch a point at least {:.0f} mm from the line",
                    1e3 * fit.spread.minCoeff(), 2e3 * min_point_spread));
  const auto count = static_cast<Eigen::Index>(points.size());
  Eigen::Matrix3Xd device(3, count), room(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    device.col(i) = points[static_cast<std::size_t>(i)].device;
    room.col(i) = points[static_cast<std::size_t>(i)].room;
  }
  const Eigen::Matrix4d m = Eigen::umeyama(device, room, false);
  fit.room_device = {m.topRightCorner<3, 1>(), Quat(Mat3(m.topLeftCorner<3, 3>())).normalized()};
  double squares = 0;
  for (const TouchedPoint& p : points) {
    fit.residuals.push_back((fit.room_device * p.device - p.room).norm());
    squares += fit.residuals.back() * fit.residuals.back();
  }
  const auto n = static_cast<double>(points.size());
  fit.fre = std::sqrt(squares / n);
  fit.fle = fit.fre / std::sqrt(1 - 2 / n);
  return fit;
}

}  // namespace prosector
