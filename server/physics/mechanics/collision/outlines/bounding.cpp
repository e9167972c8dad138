#include "server/physics/mechanics/collision/outlines/bounding.h"

#include <Eigen/Eigenvalues>

#include <cmath>

namespace prosector::collision {
namespace {

template <class F>
void for_each_point(std::span<const Cloud> clouds, const F& f) {
  for (const Cloud& cloud : clouds)
    for (const Vec3& x : cloud.points) f(x, cloud.rounding);
}

/// Returns the principal axes of the points as a right-handed frame; the axes of the given frame if all
/// points coincide.
Quat principal_axes(std::span<const Cloud> clouds) {
  double count = 0;
  Vec3 mean = Vec3::Zero();
  for_each_point(clouds, [&](const Vec3& x, double) {
    mean += x;
    count += 1;
  });
  mean /= count;
  Mat3 covariance = Mat3::Zero();
  for_each_point(clouds, [&](const Vec3& x, double) { covariance += (x - mean) * (x - mean).transpose(); });
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(covariance / count);
  Mat3 axes = eigen.eigenvectors();
  if (!axes.allFinite()) return Quat::Identity();
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  return Quat(axes).normalized();
}

}  // namespace

Aabb enclosing_box(std::span<const Cloud> clouds) {
  Aabb box;
  for_each_point(clouds, [&](const Vec3& x, double rounding) { box.add(Aabb{x, x}.grown(rounding)); });
  return box;
}

SphereShape enclosing_sphere(std::span<const Cloud> clouds) {
  return enclosing_sphere_about(enclosing_box(clouds).center(), clouds);
}

SphereShape enclosing_sphere_about(const Vec3& center, std::span<const Cloud> clouds) {
  SphereShape out{center, 0};
  for_each_point(clouds, [&](const Vec3& x, double rounding) {
    out.radius = std::max(out.radius, (x - out.center).norm() + rounding);
  });
  return out;
}

BoxShape enclosing_box_along(const Quat& axes, std::span<const Cloud> clouds) {
  const Mat3 turn = axes.toRotationMatrix().transpose();
  Aabb box;
  for_each_point(clouds, [&](const Vec3& x, double rounding) {
    const Vec3 turned = turn * x;
    box.add(Aabb{turned, turned}.grown(rounding));
  });
  return {{axes * box.center(), axes}, box.half()};
}

BoxShape enclosing_oriented_box(std::span<const Cloud> clouds) {
  const BoxShape along_frame = enclosing_box_along(Quat::Identity(), clouds);
  const BoxShape along_axes = enclosing_box_along(principal_axes(clouds), clouds);
  // Compares areas, which are also defined for flat boxes.
  const auto area = [](const BoxShape& b) {
    return b.half.x() * b.half.y() + b.half.y() * b.half.z() + b.half.z() * b.half.x();
  };
  return area(along_axes) < area(along_frame) ? along_axes : along_frame;
}

}  // namespace prosector::collision
