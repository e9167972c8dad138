#pragma once
// Users who press one organ simultaneously, spread over the part of its surface that faces up.

#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

/// A pressed point of an undeformed surface.
struct PressedPlace {
  Vec3 at = Vec3::Zero();       // m, world frame
  Vec3 outward = Vec3::Zero();  // unit
  Vec3 along = Vec3::Zero();    // unit, perpendicular to `outward`: side from which the hand comes
};

/// Returns `count` points of the body's upward-facing surface, far from each other: each is the random
/// candidate farthest from all earlier points (Mitchell 1991). The first n points are the same for any count.
/// Throws InputError if no part of the surface faces up.
std::vector<PressedPlace> spread_places(const Simulation& simulation, BodyId body, std::size_t count,
                                        unsigned seed);

/// Motion of the hands: each moves down to its point in 0.5 s, presses, and rubs to and fro by 4 mm.
class Crowd {
 public:
  /// `hands_each`: 1 or 2. `depth`: target depth of the middle fingertips, m. Hand i presses `places[i]`, so
  /// there must be a place per hand.
  Crowd(std::vector<PressedPlace> places, std::size_t users, std::size_t hands_each, double depth);

  std::size_t hands() const { return hands_; }
  /// Returns the hands' input for a tick of `h` s. The hands appear in tick 0.
  TickInput act(int tick, double h) const;

 private:
  Pose wrist(std::size_t hand, double time) const;

  std::vector<PressedPlace> places_;
  std::size_t hands_, hands_each_;
  double depth_;  // m
};

/// Returns the soft body called `name`, or, if `name` is empty, the one with the most tetrahedra. Throws
/// InputError with the names of the soft bodies if there is none.
BodyId pressed_body(const Simulation& simulation, const std::string& name);

}  // namespace prosector
