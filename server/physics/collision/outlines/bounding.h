#pragma once
// Simple shapes around points.

#include <span>

#include "server/physics/collision/narrow/box_contact.h"
#include "server/physics/collision/primitives/aabb.h"

namespace prosector {

/// Points, each a ball of radius `rounding`.
struct Cloud {
  std::span<const Vec3> points;  // m, at least one
  double rounding = 0;           // m
};

Aabb enclosing_box(std::span<const Cloud> clouds);

/// Returns the sphere about the middle of the world-axis box, out to the farthest point. The radius that is
/// often taken, the box's largest half extent, leaves out what lies towards the corners: of a cube everything
/// beyond 58 % of them. This one always encloses and is at most √3 times as large.
SphereShape enclosing_sphere(std::span<const Cloud> clouds);

SphereShape enclosing_sphere_about(const Vec3& center, std::span<const Cloud> clouds);

/// Extents along given axes.
BoxShape enclosing_box_along(const Quat& axes, std::span<const Cloud> clouds);

/// Returns the smaller of two boxes: along the frame's axes, and along the eigenvectors of the points'
/// covariance (Gottschalk, Lin and Manocha 1996).
BoxShape enclosing_oriented_box(std::span<const Cloud> clouds);

}  // namespace prosector
