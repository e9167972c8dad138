#pragma once
// Groups the points where a hand touches a body; each group becomes one contact plane.

#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

/// Points where a hand touches one side of a body, or all points at which it holds the body. Each group
/// becomes one contact plane of a haptic arm.
struct TouchGroup {
  BodyId body = 0;
  bool holds = false;  // the hand holds the body: forces pull as well as press
  std::vector<HandTouch> touches;
  Vec3 normal = Vec3::UnitY();  // unit, towards the hand; upwards for a hold that hardly pulls
  Vec3 point = Vec3::Zero();    // m, room frame: on the hand
  double pressing = 0;        // N: magnitude of the resultant of the normal or holding forces, along `normal`
  Vec3 force = Vec3::Zero();  // N, on the hand, friction included
};

inline constexpr double same_side = 0.7;  // cosine: normals with a smaller angle belong to one plane

/// Groups a hand's touches; each group becomes one contact plane. A group contains all touches of a body if
/// they press in one direction, otherwise those of one of its sides. Groups of holds come first. Returns at
/// most `max_contact_planes` groups.
std::vector<TouchGroup> grouped(std::vector<HandTouch> touches);

}  // namespace prosector
