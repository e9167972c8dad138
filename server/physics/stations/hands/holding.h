#pragma once
// Holds of hands: their forces, and how they end without a release by the user: torn, or set down.

#include <span>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// A pair of held points of a hand and its held body, at their current positions; m, world frame.
struct HeldPoint {
  Vec3 at_hand, at_body;
  double stiffness, max_force;  // N/m, N
  Vec3 force() const;           // N, on the held body
};
/// Returns the points of the hand's hold. The hand must hold a body.
std::vector<HeldPoint> held_points(const Bodies& bodies, const Hand& hand);
/// Returns the force of the hold on the held body, N.
Vec3 hold_force(const Bodies& bodies, const Hand& hand);

/// Returns the compliance of a point of the held rigid body in the grip, m/N.
Mat3 grip_give(const Bodies& bodies, const Hand& hand, const Vec3& point);

/// Releases, after a tick, bodies that were torn from hands or set down. `islands`: of that tick; `h`: s, of
/// its last part.
void update_holds(State& state, std::span<const Island> islands, double h, StepReport& report);

/// Moves holds to the nearest vertices of these bodies (soft, ascending) after a cut changed them.
void keep_holds(State& state, const std::vector<std::size_t>& pieces);
/// Moves the hold to the piece of a broken bone that has most of its points.
void hand_over(Bodies& bodies, Hand& hand, const RigidModel::Fracture& plane);

}  // namespace prosector
