#pragma once
// Matrices of cameras and lights (column vectors, OpenGL clip space), and frustum tests.

#include <array>

#include "client/view/bounds.h"

namespace prosector {

Eigen::Matrix4d matrix_of(const Pose& pose);
Eigen::Matrix4d matrix_of(const Affine& affine);
/// Returns the matrix from the item's mesh to the room.
Eigen::Matrix4d matrix_of(const DrawItem& item);

/// Returns the clipping plane for the shaders' uniform `kept`: its product with a point is positive on the
/// remaining side.
Eigen::Vector4d clip_plane_of(const SectionPlane& section);

inline const Eigen::Vector4d no_clip_plane{0, 0, 0, 1};  // for items that no section opens

/// Returns the camera's off-axis projection, from eye space to clip space.
Eigen::Matrix4d projection_of(const DrawCamera& camera);

/// Returns the matrix from the room to clip space.
Eigen::Matrix4d view_projection_of(const DrawCamera& camera);

/// The six planes of a clip matrix (Gribb and Hartmann 2001).
class Frustum {
 public:
  explicit Frustum(const Eigen::Matrix4d& clip_from_room);
  /// Returns false only when the sphere is outside.
  bool may_see(const Sphere& sphere) const;

 private:
  std::array<Eigen::Vector4d, 6> planes_;  // unit normals pointing inwards
};

}  // namespace prosector
