#pragma once
// Bounding volumes of point clouds.

#include <span>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector::collision {

/// Point cloud to be enclosed by a bounding volume. Each point stands for a ball of radius `rounding`.
struct Cloud {
  std::span<const Vec3> points;  // m, at least one
  double rounding = 0;           // m
};

Aabb enclosing_box(std::span<const Cloud> clouds);

/// Returns a sphere that encloses all balls of the clouds. Its centre is that of their bounding box along the
/// frame's axes, and it reaches to the farthest point plus rounding. Its radius is at most √3 times the
/// smallest possible radius. (A sphere whose radius is the box's largest half extent would not enclose: it
/// reaches only 58 % of the way to a cube's corners.)
SphereShape enclosing_sphere(std::span<const Cloud> clouds);

SphereShape enclosing_sphere_about(const Vec3& center, std::span<const Cloud> clouds);

/// Returns the smallest box with the given orientation that encloses all balls of the clouds. `axes`:
/// rotation from the box's axes to the clouds' frame.
BoxShape enclosing_box_along(const Quat& axes, std::span<const Cloud> clouds);

/// Returns a box that encloses all balls of the clouds. It is the smaller of two boxes: one along the frame's
/// axes, and one along the eigenvectors of the points' covariance (Gottschalk, Lin and Manocha 1996).
BoxShape enclosing_oriented_box(std::span<const Cloud> clouds);

}  // namespace prosector::collision
