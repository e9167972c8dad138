#pragma once
// What hands hold: which forces act, and how a hold ends without being let go: torn, or set down.

#include <span>
#include <vector>

#include "server/physics/island.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// A point that a hand and what it holds share, where each has it now; m, world frame.
struct HeldPoint {
  Vec3 at_hand, at_body;
  double stiffness, max_force;  // N/m, N
  Vec3 force() const;           // N, on what is held
};
/// Returns the points of the hand's hold, which it has.
std::vector<HeldPoint> held_points(const Bodies& bodies, const Hand& hand);
/// Returns the force of the hold on what is held, N.
Vec3 hold_force(const Bodies& bodies, const Hand& hand);

/// Returns how far a point of the rigid body that the hand holds yields in its grip under a force on it, m/N.
Mat3 grip_give(const Bodies& bodies, const Hand& hand, const Vec3& point);

/// Makes hands let go, after a tick, of what was torn from them or set down. `islands`: of that tick; `h`: s,
/// of its last part.
void tend_holds(State& state, std::span<const Island> islands, double h, StepReport& report);

/// Lets hands go on holding what is nearest to where they held it, where a cut changed these bodies (soft
/// ones, ascending).
void keep_holds(State& state, const std::vector<std::size_t>& pieces);
/// Lets the hand go on holding the piece of a broken bone that most of its hold is on.
void hand_over(Bodies& bodies, Hand& hand, const RigidModel::Fracture& plane);

}  // namespace prosector
