#pragma once
// Two organs thrown at each other, and what is measured of soft bodies that fly.

#include <functional>

#include "server/physics/simulation.h"

namespace prosector::test {

/// How a body is simulated.
struct ThrownRung {
  std::string model, integrator;
  std::string name() const { return model + ", " + integrator; }
};

/// Two livers in the air, side by side along x, without damping: bodies 0 and 1.
SceneDesc two_livers(const ThrownRung& left, const ThrownRung& right, double cell);
inline constexpr double thrown_speed = 2;  // m/s, of each

/// Gives every node of an awake soft body that moves this velocity, m/s.
void throw_body(Simulation& simulation, BodyId body, const Vec3& velocity);

Vec3 momentum(const Simulation& simulation, BodyId soft_body);
Vec3 centre(const Simulation& simulation, BodyId soft_body);  // mean of its nodes
/// m, by how much the distance between two of its surface's points differs most from that at rest, wherever
/// the body flew.
double distortion(const Simulation& simulation, BodyId soft_body);

/// Throws the bodies of two_livers() at each other and watches for `ticks`.
struct Thrown {
  double momentum_lost = 0;     // most over the ticks, of what they exchanged
  double exchanged = 0;         // kg·m/s
  double energy_gained = 0;     // most over the ticks, of what they had
  double deepest = 0;           // m: overlap(), most over the ticks
  double overlap_after = 0;     // m
  double parting = 0;           // m/s, along the line between their centres, at the end
  double distortion_after = 0;  // m, of the worse one
  int reported = 0;             // ticks in which a body was reset or not solved well
  bool finite = true;
};
/// `step`: one tick of the simulation.
Thrown throw_at_each_other(Simulation& simulation, int ticks, const std::function<const StepReport&()>& step);

}  // namespace prosector::test
