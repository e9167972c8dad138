#pragma once
// Compiled collision settings of a soft body.

#include "common/fidelity.h"
#include "server/physics/mechanics/collision/broad/collision_mask.h"
#include "server/physics/mechanics/rigid/room.h"

namespace prosector::contact {

struct SoftCollision {
  Fidelity fidelity = Fidelity::mesh;
  collision::CollisionMask mask;
  rigid::RoomSides passes = 0;  // sides of the room that the body passes through
  bool continuous = false;
  bool with_itself = false;
  double cell = 0;              // m, for self-collision: mean edge of the surface as compiled; ropes: 0
  double stiffness_factor = 1;  // the scene's contact_stiffness
  // Contact with rigid bodies is integrated over the touching area, not taken at vertices.
  bool over_area = false;
};

}  // namespace prosector::contact
