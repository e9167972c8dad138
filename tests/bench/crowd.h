#pragma once
// People who press one organ at once, each with both hands, spread over the part of it that looks up.

#include <vector>

#include "server/physics/simulation.h"

namespace prosector {

/// A place on a surface that is pressed, at rest.
struct PressedPlace {
  Vec3 at = Vec3::Zero();       // m, world frame
  Vec3 outward = Vec3::Zero();  // unit
  Vec3 along = Vec3::Zero();    // unit, across `outward`: from where the hand comes
};

/// Returns so many places of the body's surface that look up, far from each other: each is the farthest from
/// all before it of some drawn at random (Mitchell 1991). The first n are the same for any count.
std::vector<PressedPlace> spread_places(const Simulation& simulation, BodyId body, std::size_t count,
                                        unsigned seed);

/// Their hands: they come down on their places in half a second, press, and rub to and fro a little.
class Crowd {
 public:
  /// `hands_each`: 1 or 2. `depth`: m, how far in middle fingertips are aimed. Places are taken in order;
  /// there must be enough.
  Crowd(std::vector<PressedPlace> places, std::size_t users, std::size_t hands_each, double depth);

  std::size_t hands() const { return hands_; }
  /// Returns what they do in the tick, `h` s long; they appear in tick 0.
  TickInput act(int tick, double h) const;

 private:
  Pose wrist(std::size_t hand, double time) const;

  std::vector<PressedPlace> places_;
  std::size_t hands_, hands_each_;
  double depth_;  // m
};

/// Returns the body that is named so, or, if none is asked for, the soft one of the most tetrahedra. Throws
/// InputError that lists the soft bodies.
BodyId pressed_body(const Simulation& simulation, const std::string& name);

}  // namespace prosector
