#pragma once
// Energy safeguard: no tick may give energy to a soft body.
//
// A minimiser of implicit Euler's potential dissipates energy. An iterate that was stopped early or found no
// descent may gain energy. BDF2 and TR-BDF2 may gain energy too, because a nonlinear body may not follow
// their extrapolation. So after each tick a body's total energy (elastic, kinetic, gravitational) is compared
// with a bound. The bound is the energy at the tick's start plus the work of joints and a slack.
//
// The slack is how much more energy the body had recently, with a half-life of 2 s. In multi-step methods the
// energy oscillates about a mean as slowly as the body itself. With a shorter half-life, normal oscillations
// would count as gains, and each repeated tick costs a spinning body a hundredth of its energy. No slack,
// however large, lets a body gain energy permanently.
//
// Bodies in contact or ties exchange energy with others: for them island_solver.h checks the energy of the
// island.

#include <vector>

#include "server/physics/mechanics/coupled/island.h"

namespace prosector::coupled {

/// Limits the velocity of each node of a soft body, relative to the body's mean velocity, to ten diagonals of
/// the body per tick of h s. Sets `limited` in the member if a velocity was reduced. No sensible input causes
/// higher speeds, and no time step could resolve them.
void limit_speed(SoftMember& member, double h);

/// Energy safeguard: compares the energy of each soft body of an island after a tick with its bound, the
/// energy before plus external work. Shortens the motion of bodies that exceed it.
class EnergyGuard {
 public:
  /// Starts a tick: stores the motion and the energy of the island's soft bodies, for rewind() and for the
  /// comparison after the tick. `island` must outlive the tick.
  void begin(Island& island);

  /// Returns whether the energies of all soft bodies of the island were finite at the start of the tick. If
  /// not, their states are unusable.
  bool sound() const;
  /// Returns the energy (elastic and kinetic, in J) of all soft bodies of the island at the start of the
  /// tick.
  double before() const;
  /// Returns whether, after the tick, some soft body of the island has more energy than its bound. `work`:
  /// work (J) of contacts and ties on each soft body during the tick.
  bool gained(const std::vector<double>& work);
  /// Restores the motion of the island's soft bodies at the start of the tick, so that the tick can be
  /// repeated.
  void rewind();
  /// Reduces the motion of each soft body that gained energy in this tick until it is within its energy
  /// bound. The motion relative to the body's mean motion is scaled by ½, ¼ and so on, and finally by 0. If
  /// that does not suffice, the body stops at its position of the tick's start. `work`: work (J) of contacts
  /// and ties on each soft body during the tick.
  void shorten(const std::vector<double>& work);
  /// Accepts the tick of h s. Updates each soft body's energy slack, the amount by which its energy may rise
  /// next, from the difference between bound and energy. `work`: work (J) of contacts and ties on each soft
  /// body.
  void finish(const std::vector<double>& work, double h);

 private:
  double stored(const SoftMember& member) const;
  double allowed(std::size_t m, double work) const;

  Island* island_ = nullptr;
  std::vector<double> before_, after_;  // J, elastic and kinetic, of each soft member
};

}  // namespace prosector::coupled
