#pragma once
// Cameras and lights as matrices (column vectors, OpenGL clip space), and what they can see.

#include <array>

#include "client/view/bounds.h"

namespace prosector {

Eigen::Matrix4d matrix_of(const Pose& pose);
Eigen::Matrix4d matrix_of(const Affine& affine);
/// Maps the item's mesh to the room.
Eigen::Matrix4d matrix_of(const DrawItem& item);

/// Returns the plane as the shaders' `kept`: its product with a place is above zero on the side that stays.
Eigen::Vector4d kept_side(const SectionPlane& section);

inline const Eigen::Vector4d kept_whole{0, 0, 0, 1};  // of what no section opens

/// Returns the off-axis frustum of the camera: clip from eye space.
Eigen::Matrix4d projection_of(const DrawCamera& camera);

/// Maps the room to clip space.
Eigen::Matrix4d view_projection_of(const DrawCamera& camera);

/// The six planes of a clip matrix (Gribb and Hartmann 2001).
class Frustum {
 public:
  explicit Frustum(const Eigen::Matrix4d& clip_from_room);
  /// Returns false only when the sphere is outside.
  bool may_see(const Sphere& sphere) const;

 private:
  std::array<Eigen::Vector4d, 6> planes_;  // normal inwards, unit
};

}  // namespace prosector
