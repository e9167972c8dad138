#pragma once
// How a soft body collides, as compiled.

#include "server/physics/collision/broad/collision_mask.h"
#include "server/physics/collision/shapes/fidelity.h"
#include "server/physics/rigid/room.h"

namespace prosector {

struct SoftCollision {
  Fidelity fidelity = Fidelity::mesh;
  CollisionMask mask;
  RoomSides passes = 0;  // of the room: it goes through these
  bool continuous = false;
  bool with_itself = false;
  double cell = 0;              // m, of what meets itself: mean edge of its surface as compiled
  double stiffness_factor = 1;  // the scene's contact_stiffness
  bool over_area = false;       // rigid things press it over the area that touches, not at its vertices
};

}  // namespace prosector
