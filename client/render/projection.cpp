#include "client/render/projection.h"

namespace prosector {

Eigen::Matrix4d matrix_of(const Pose& pose) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = pose.q.toRotationMatrix();
  m.topRightCorner<3, 1>() = pose.p;
  return m;
}

Eigen::Matrix4d matrix_of(const Affine& affine) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = affine.A;
  m.topRightCorner<3, 1>() = affine.p;
  return m;
}

Eigen::Matrix4d matrix_of(const DrawItem& item) {
  return matrix_of(item.shape) * matrix_of(item.pose);
}

Eigen::Vector4d clip_plane_of(const SectionPlane& section) {
  return {-section.normal.x(), -section.normal.y(), -section.normal.z(), section.offset};
}

Eigen::Matrix4d projection_of(const DrawCamera& c) {
  const double wide = c.right - c.left, high = c.top - c.bottom, deep = c.far - c.near;
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = 2 / wide;
  m(0, 2) = (c.right + c.left) / wide;
  m(1, 1) = 2 / high;
  m(1, 2) = (c.top + c.bottom) / high;
  m(2, 2) = -(c.far + c.near) / deep;
  m(2, 3) = -2 * c.far * c.near / deep;
  m(3, 2) = -1;
  return m;
}

Eigen::Matrix4d view_projection_of(const DrawCamera& camera) {
  return projection_of(camera) * matrix_of(camera.pose.inverse());
}

Frustum::Frustum(const Eigen::Matrix4d& m) {
  for (int axis = 0; axis < 3; ++axis) {
    planes_[static_cast<std::size_t>(2 * axis)] = (m.row(3) + m.row(axis)).transpose();
    planes_[static_cast<std::size_t>(2 * axis + 1)] = (m.row(3) - m.row(axis)).transpose();
  }
  for (Eigen::Vector4d& plane : planes_) plane /= plane.head<3>().norm();
}

bool Frustum::may_see(const Sphere& sphere) const {
  for (const Eigen::Vector4d& plane : planes_)
    if (plane.head<3>().dot(sphere.center) + plane.w() < -sphere.radius) return false;
  return true;
}

}  // namespace prosector
