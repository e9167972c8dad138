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

namespace prosector {

/// Limits node velocities relative to the body's mean to ten of its diagonals per tick of h s, and sets
/// `limited` in the member. No sensible input causes higher speeds, and no step could resolve them.
void limit_speed(SoftMember& member, double h);

/// Compares the energy of each soft body with its bound, and shortens ticks that exceed it.
class EnergyGuard {
 public:
  /// Starts a tick: stores the soft members' motion. The island must outlive this tick.
  void begin(Island& island);

  /// Returns whether all energies at the tick's start are finite.
  bool sound() const;
  /// Returns the energy of all soft members at the tick's start, J.
  double before() const;
  /// Returns after the tick whether some member has more energy than its bound. `work`: J, by joints, on each
  /// member.
  bool gained(const std::vector<double>& work);
  /// Restores the members' state at the tick's start.
  void rewind();
  /// Shortens the tick of the members that gained energy until they have not. Motion relative to the body's
  /// mean motion is scaled by ½, ¼, … or 0.
  void shorten(const std::vector<double>& work);
  /// Accepts the tick of h s and updates the energy slack.
  void finish(const std::vector<double>& work, double h);

 private:
  double stored(const SoftMember& member) const;
  double allowed(std::size_t m, double work) const;

  Island* island_ = nullptr;
  std::vector<double> before_, after_;  // J, elastic and kinetic, of each soft member
};

}  // namespace prosector
