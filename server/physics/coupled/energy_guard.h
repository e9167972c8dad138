#pragma once
// No tick gives a soft body energy.
//
// A minimiser of implicit Euler's potential loses energy by itself; an iterate that was stopped early, or
// that found no descent, need not, nor need BDF2 and TR-BDF2, whose extrapolations a nonlinear body may not
// follow. So after each tick a body's total energy (elastic, kinetic, of weight) is compared with what it had
// when the tick began, what joints did to it, and a slack: what it had more of late, halved in 2 s, because
// methods of several steps swing about the energy they keep, as slowly as the body itself. A slack that is
// forgotten sooner than that takes healthy swings for gains, and each tick taken again costs a spinning body
// a hundredth of its energy. However large, it lets no body have more than it had.
//
// What touches or holds others exchanges energy with them: island_solver.h watches its island's.

#include <vector>

#include "server/physics/island.h"

namespace prosector {

/// Nodes that run away from their body's mean by more than ten of its diagonals in a tick of h s are held to
/// that, and the member says so: no input that makes sense asks for more, and beyond it no step resolves
/// anything.
void limit_speed(SoftMember& member, double h);

class EnergyGuard {
 public:
  /// Starts a tick: remembers the soft members' motion. The island must outlive it.
  void begin(Island& island, const Vec3& gravity);

  /// Whether the tick began with energies that are numbers.
  bool sound() const;
  /// J, of all soft members, when the tick began.
  double before() const;
  /// After the tick: whether some member has more energy than explained; `work`: J, by joints, of each.
  bool gained(const std::vector<double>& work);
  /// Back to the tick's start.
  void rewind();
  /// Takes back so much of the tick of those that gained that they did not: all of a body but its mean motion
  /// goes a part of the way, ½, ¼, … or none.
  void shorten(const std::vector<double>& work);
  /// The tick of h s stands.
  void finish(const std::vector<double>& work, double h);

 private:
  double stored(const SoftMember& member) const;
  double allowed(std::size_t m, double work) const;

  Island* island_ = nullptr;
  Vec3 gravity_ = Vec3::Zero();
  std::vector<double> before_, after_;  // J, elastic and kinetic, of each soft member
};

}  // namespace prosector
