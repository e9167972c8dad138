#pragma once
// No tick gives a soft body energy.
//
// A minimiser of implicit Euler's potential loses energy by itself. An iterate that was stopped early or
// found no descent need not, and neither need BDF2 and TR-BDF2, whose extrapolations a nonlinear body may not
// follow. So after each tick a body's total energy (elastic, kinetic, of weight) is compared with a bound.
// The bound is what it had when the tick began, what joints did to it, and a slack. The slack is what it had
// more of late, halved in 2 s: methods of several steps swing about the energy they keep, as slowly as the
// body itself. A slack that is forgotten sooner than that takes healthy swings for gains, and each tick taken
// again costs a spinning body a hundredth of its energy. However large, it lets no body have more than it
// had.
//
// What touches or holds others exchanges energy with them: island_solver.h watches its island's.

#include <vector>

#include "server/physics/island.h"

namespace prosector {

/// Holds nodes to ten of their body's diagonals in a tick of h s, relative to the body's mean, and says so in
/// the member. No input that makes sense asks for more, and beyond it no step resolves anything.
void limit_speed(SoftMember& member, double h);

class EnergyGuard {
 public:
  /// Starts a tick: remembers the soft members' motion. The island must outlive it.
  void begin(Island& island);

  /// Tells whether the tick began with energies that are numbers.
  bool sound() const;
  /// Returns the energy of all soft members when the tick began, J.
  double before() const;
  /// Tells after the tick whether some member has more energy than explained. `work`: J, by joints, on each.
  bool gained(const std::vector<double>& work);
  /// Takes the members back to the tick's start.
  void rewind();
  /// Takes back so much of the tick of those that gained that they did not. All of a body but its mean motion
  /// goes a share of the way: ½, ¼, … or none.
  void shorten(const std::vector<double>& work);
  /// Accepts the tick of h s as it stands.
  void finish(const std::vector<double>& work, double h);

 private:
  double stored(const SoftMember& member) const;
  double allowed(std::size_t m, double work) const;

  Island* island_ = nullptr;
  std::vector<double> before_, after_;  // J, elastic and kinetic, of each soft member
};

}  // namespace prosector
