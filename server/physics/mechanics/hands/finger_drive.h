#pragma once
// Flexion of a finger within a tick: a spring with bounded force drives it towards its tracked flexion,
// against obstacles. Obstacles resist with the contacts' own stiffness. So the force of a finger at rest on a
// body is known from its penetration depth. The flexion is the only state.

#include <span>

namespace prosector::hands {

/// Contact of a finger with a body, actual or imminent, as an obstacle to the finger's flexion. The gap is
/// measured along the contact normal.
struct Obstacle {
  double gap = 0;        // m, < 0 penetrates
  double way = 0;        // m: decrease of the gap per unit of flexion; < 0: the gap increases
  double stiffness = 0;  // N/m, of the contact
  double series = 0;     // N/m: of the contact in series with the body behind it, at most `stiffness`
};

/// Parameters of the spring with bounded force that drives a finger towards its tracked flexion.
struct FingerDrive {
  double max_force = 0;  // N, against all obstacles together
  double lag = 0.5;      // of flexion: lag behind the tracked finger at which the full force is reached
};

/// Returns the finger's change of flexion in one tick, within ±`most`, at which the drive's force balances
/// the obstacles' resistance. Flexion is 0 for a straight finger and 1 for a bent one. The force is below
/// `drive.max_force`, unless obstacles push the finger back faster than `most` allows.
double finger_step(double tracked, double flexion, double most, std::span<const Obstacle> obstacles,
                   const FingerDrive& drive);

}  // namespace prosector::hands
