#pragma once
// Tissue under a ball that is driven into it, as a test machine would: the scene, the drive, the force.

#include "server/physics/simulation.h"

namespace prosector::test {

/// Returns a room without gravity. Body 0 is a ball without friction that only drives move, with its middle
/// there; body 1 is the tissue.
SceneDesc under_ball(SoftDesc tissue, double radius, const Vec3& middle);

/// Returns what holds the underside of a layer that reaches from y = −height, m, to 0, and nothing above it.
AttachDesc bonded_below(double height);

/// Drives the ball's middle there.
TickInput ball_at(const Vec3& middle);

/// Returns the force along y with which bodies pressed each other in the last tick, N.
double pressing_force(const Simulation& simulation);

}  // namespace prosector::test
