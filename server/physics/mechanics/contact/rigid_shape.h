#pragma once
// Collision geometry of a rigid body for contact with soft bodies.

#include <memory>
#include <vector>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/contact/signed_distance.h"

namespace prosector {

/// Parts of a rigid body with their distance functions, in its centre-of-mass frame.
struct RigidShape {
  std::vector<ShapePart> parts;
  std::vector<std::unique_ptr<SignedDistance>> distances;
};

}  // namespace prosector
