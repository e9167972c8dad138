#pragma once
// Signed distance to a rigid part: closed forms for primitives, a sampled grid for meshes.

#include <memory>

#include "server/physics/collision/shapes/shape.h"

namespace prosector {

struct Distance {
  double value = 0;             // m, < 0 inside
  Vec3 normal = Vec3::UnitY();  // unit, outwards
  double curvature = 0;         // 1/m: sum of the principal ones there of what is round; 0: it is flat
};

class SignedDistance {
 public:
  virtual ~SignedDistance() = default;
  /// Returns the distance at a point in the part's own frame.
  virtual Distance at(const Vec3& x) const = 0;
};

/// Makes the distance to a part. It is exact outside and inside for box, sphere, capsule and cylinder. For an
/// ellipsoid it is exact on the surface and of first order near it; for meshes trilinear between samples (see
/// GridDistance).
std::unique_ptr<SignedDistance> make_signed_distance(const ShapePart& part);

}  // namespace prosector
