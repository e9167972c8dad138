#pragma once
// Signed distance to a rigid part: closed forms for primitives, a sampled grid for meshes.

#include <memory>

#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector {

/// Distance from a point to a surface.
struct Distance {
  double value = 0;             // m, < 0 inside
  Vec3 normal = Vec3::UnitY();  // unit, outwards
  double curvature = 0;         // 1/m: sum of the principal curvatures of a round surface; 0: flat
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Returns the distance at a point in the part's own frame.
  virtual Distance at(const Vec3& x) const = 0;
};

/// Creates the distance function of a part. It is exact outside and inside for box, sphere, capsule and
/// cylinder. For an ellipsoid it is exact on the surface and of first order near it. For meshes it is
/// trilinear between samples (see GridDistance).
std::unique_ptr<SignedDistance> make_signed_distance(const ShapePart& part);

}  // namespace prosector
