#pragma once
// Groups the points where a hand touches a body; each group becomes one contact plane.

#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

/// Touches on one side of a body, or all points at which the hand holds the body.
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

/// Groups touches into planes: all touches of a body if they press in one direction, else those of each side.
/// Holds come first. Returns at most `max_contact_planes` groups.
std::vector<TouchGroup> grouped(std::vector<HandTouch> touches);

}  // namespace prosector
