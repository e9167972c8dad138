#pragma once
// Holds of hands: their forces, and how they end without a release by the user: torn, or set down.

#include <span>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// A pair of points, of a hand and of the body that it holds, which a spring pulls together. Current
/// positions in m, world frame.
struct HeldPoint {
  Vec3 at_hand, at_body;
  double stiffness, max_force;  // N/m, N
  Vec3 force() const;           // N, on the held body
};
/// Returns the point pairs by which the hand holds its body, at their current positions. The hand must hold a
/// body.
std::vector<HeldPoint> held_points(const Bodies& bodies, const hands::Hand& hand);
/// Returns the total force (N) with which the hand's hold pulls the held body. The hand must hold a body.
Vec3 hold_force(const Bodies& bodies, const hands::Hand& hand);

/// Returns the compliance (m/N) of a hand's grip at `point` (m, world frame) of the rigid body that it holds.
/// It is the displacement of that point per force on it, while the hand stays fixed.
Mat3 grip_give(const Bodies& bodies, const hands::Hand& hand, const Vec3& point);

/// Releases, after a tick, bodies that were torn from hands or were set down, and reports it. `islands` (sets
/// of bodies that are solved together) are those of the tick's last part, and `h` is that part's duration in
/// s.
void update_holds(State& state, std::span<const coupled::Island> islands, double h, StepReport& report);

/// Moves the points of holds on these bodies to the nearest vertices after a cut changed the bodies. `pieces`
/// are indices of soft bodies, ascending. A hand whose points are then on several pieces keeps only those on
/// the piece that has most of them.
void keep_holds(State& state, const std::vector<std::size_t>& pieces);
/// Moves a hand's hold on a bone that broke at the fracture plane `plane` to the fragment that has most of
/// its points.
void hand_over(Bodies& bodies, hands::Hand& hand, const RigidModel::Fracture& plane);

}  // namespace prosector
