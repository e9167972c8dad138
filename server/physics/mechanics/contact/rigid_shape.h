#pragma once
// Collision geometry of a rigid body for contact with soft bodies.

#include <memory>
#include <vector>

#include "server/physics/mechanics/collision/shapes/shape.h"
#include "server/physics/mechanics/contact/signed_distance.h"

namespace prosector::contact {

/// Collision parts of a rigid body, in its centre-of-mass frame, each with its signed distance function.
struct RigidShape {
  std::vector<collision::ShapePart> parts;
  std::vector<std::unique_ptr<SignedDistance>> distances;
};

}  // namespace prosector::contact
