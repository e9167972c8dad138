#pragma once
// Matrices of cameras and lights (column vectors, OpenGL clip space), and frustum tests.

#include <array>

#include "client/view/bounds.h"

namespace prosector {

Eigen::Matrix4d matrix_of(const Pose& pose);
Eigen::Matrix4d matrix_of(const Affine& affine);
/// Returns the 4 × 4 matrix that transforms points of the item's mesh to the room.
Eigen::Matrix4d matrix_of(const DrawItem& item);

/// Returns a section's clipping plane, in room coordinates, as the shaders' uniform `kept`. Its product with
/// a point's homogeneous coordinates is positive on the side that the section does not remove.
Eigen::Vector4d clip_plane_of(const SectionPlane& section);

inline const Eigen::Vector4d no_clip_plane{0, 0, 0, 1};  // for items that no section opens

/// Returns the camera's off-axis projection matrix, from eye space to OpenGL's clip space.
Eigen::Matrix4d projection_of(const DrawCamera& camera);

/// Returns the camera's 4 × 4 matrix that transforms points of the room to OpenGL's clip space.
Eigen::Matrix4d view_projection_of(const DrawCamera& camera);

/// View frustum as six planes, which are extracted from a matrix to clip space (Gribb and Hartmann 2001).
class Frustum {
 public:
  explicit Frustum(const Eigen::Matrix4d& clip_from_room);
  /// Returns false only if the sphere is completely outside one of the frustum's planes, and thus invisible.
  bool may_see(const Sphere& sphere) const;

 private:
  std::array<Eigen::Vector4d, 6> planes_;  // unit normals pointing inwards
};

}  // namespace prosector
