#pragma once
// Bounding volumes of point clouds.

#include <span>

#include "server/physics/mechanics/collision/narrow/box_contact.h"
#include "server/physics/mechanics/collision/primitives/aabb.h"

namespace prosector {

/// Point cloud: each point is a ball of radius `rounding`.
struct Cloud {
  std::span<const Vec3> points;  // m, at least one
  double rounding = 0;           // m
};

Aabb enclosing_box(std::span<const Cloud> clouds);

/// Returns the sphere centred on the world-axis box that reaches to the farthest point. It encloses all
/// points and is at most √3 times the smallest radius. A sphere with the box's largest half extent as radius
/// would not enclose: it reaches only 58 % of the way to a cube's corners.
SphereShape enclosing_sphere(std::span<const Cloud> clouds);

SphereShape enclosing_sphere_about(const Vec3& center, std::span<const Cloud> clouds);

/// Returns the box that encloses the points along given axes.
BoxShape enclosing_box_along(const Quat& axes, std::span<const Cloud> clouds);

/// Returns the smaller of two boxes: along the frame's axes, or along the eigenvectors of the points'
/// covariance (Gottschalk, Lin and Manocha 1996).
BoxShape enclosing_oriented_box(std::span<const Cloud> clouds);

}  // namespace prosector
