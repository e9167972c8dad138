#pragma once
// How far a finger bends within a tick: towards where it is tracked, with a force that is bounded, against
// what it meets. A spring with a bound drives it. What it meets resists by the contacts' own stiffness, so
// the force of a finger at rest on something is known from how deep it is. There is no state but the flexion.

#include <span>

namespace prosector {

/// Where a finger touches something, or will soon. Lengths are counted against the normal.
struct Obstacle {
  double gap = 0;        // m, < 0 penetrates
  double way = 0;        // m that bending by 1 closes of the gap; < 0: that it opens
  double stiffness = 0;  // N/m, of the contact
  double series = 0;     // N/m: with what gives way behind it, up to `stiffness`
};

struct FingerDrive {
  double max_force = 0;  // N, on all that resists together
  double lag = 0.5;      // of flexion: how far behind the tracked finger the whole force is there
};

/// Returns the change of flexion, at most `most` either way, that balances drive and resistance. The force is
/// below the drive's bound, unless the obstacles came towards the finger faster than that.
double finger_step(double tracked, double flexion, double most, std::span<const Obstacle> obstacles,
                   const FingerDrive& drive);

}  // namespace prosector
