#pragma once
// Signed distance to a rigid part: closed forms for primitives, a sampled grid for meshes.

#include <memory>

#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector::contact {

/// Signed distance from a point to the surface of a body, with the surface's normal and curvature there.
struct Distance {
  double value = 0;             // m, < 0 inside
  Vec3 normal = Vec3::UnitY();  // unit, outwards
  double curvature = 0;         // 1/m: sum of the principal curvatures of a round surface; 0: flat
  std::uint32_t part = 0;       // index of the nearest part of the body
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Returns the signed distance of the part's surface at the point x (m); point and normal are in the part's
  /// own frame.
  virtual Distance at(const Vec3& x) const = 0;
};

/// Creates the signed distance function of a collision part. It is exact outside and inside for a box,
/// sphere, capsule and cylinder. For an ellipsoid it is exact on the surface and accurate to first order near
/// it. For a mesh it is interpolated between samples on a grid (see GridDistance).
std::unique_ptr<SignedDistance> make_signed_distance(const collision::ShapePart& part);

}  // namespace prosector::contact
