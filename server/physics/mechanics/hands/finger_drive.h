#pragma once
// Flexion of a finger within a tick: a spring with bounded force drives it towards its tracked flexion,
// against obstacles. Obstacles resist with the contacts' own stiffness. So the force of a finger at rest on a
// body is known from its penetration depth. The flexion is the only state.

#include <span>

namespace prosector {

/// An actual or imminent contact of a finger. Lengths are measured against the contact normal.
struct Obstacle {
  double gap = 0;        // m, < 0 penetrates
  double way = 0;        // m: decrease of the gap per unit of flexion; < 0: the gap increases
  double stiffness = 0;  // N/m, of the contact
  double series = 0;     // N/m: of the contact in series with the body behind it, at most `stiffness`
};

/// Parameters of the finger's drive.
struct FingerDrive {
  double max_force = 0;  // N, against all obstacles together
  double lag = 0.5;      // of flexion: lag behind the tracked finger at which the full force is reached
};

/// Returns the change of flexion, within ±`most`, that balances drive and resistance. The force is below the
/// drive's bound, unless obstacles approach the finger faster than `most`.
double finger_step(double tracked, double flexion, double most, std::span<const Obstacle> obstacles,
                   const FingerDrive& drive);

}  // namespace prosector
