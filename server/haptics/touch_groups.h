#pragma once
// Points where a hand meets a body, put together to what one contact plane tells.

#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

/// Touches of one body from one side, or all places where the hand holds it.
struct TouchGroup {
  BodyId body = 0;
  bool holds = false;  // the hand pulls it as well as it presses
  std::vector<HandTouch> touches;
  Vec3 normal = Vec3::UnitY();  // unit, towards the hand; of what is held and hardly pulls: upwards
  Vec3 point = Vec3::Zero();    // m, room: on the hand
  double pressing = 0;          // N: size of the sum of what presses or pulls, which is along the normal
  Vec3 force = Vec3::Zero();    // N, on the hand, friction included
};

inline constexpr double same_side = 0.7;  // cosine: normals that are nearer to each other are of one plane

/// Puts touches that become one plane together: those of a body, if they press one way, else those of a side.
/// What the hand holds comes first. There are no more groups than planes are told.
std::vector<TouchGroup> grouped(std::vector<HandTouch> touches);

}  // namespace prosector
