#pragma once
// Keeps the arm from giving a hand energy that nobody put in: a passivity observer and controller in time
// (Hannaford & Ryu 2002, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
// Automation 18). Delay, lost messages or a wrong estimate of stiffness would.
//
// Forces are held between cycles, so the energy is known exactly: F of the last cycle times the way since.

#include "common/math.h"

namespace prosector {

/// What went through the hand since the arm was taken up, J. Both only grow.
struct EnergyBook {
  double taken = 0;  // from the hand
  double given = 0;  // to the hand
};

class Passivity {
 public:
  /// Counts what the force of the last cycle did on the way to `position`, m. `stored`: what the contacts
  /// hold now as springs, J, which the hand gets back. `surroundings`: W, that moving surfaces give.
  void observe(const Vec3& position, double stored, double surroundings, double dt);
  /// Returns the force with as much damping as spends what the hand got too much, within what arms bear.
  /// Cutting the force instead makes it chatter: a limit cycle at 3 kN/m (docs/decisions).
  Vec3 damp(const Vec3& force, const Vec3& velocity, double dt);
  /// Tells which force acts from now on, N.
  void applied(const Vec3& force) { force_ = force; }
  /// Forgets where the hand was: nothing is known of the way it takes meanwhile.
  void interrupt() { known_ = false; }

  const EnergyBook& book() const { return book_; }
  double level() const { return level_; }  // J: what the hand put in and did not get back

 private:
  bool known_ = false;
  Vec3 position_ = Vec3::Zero(), force_ = Vec3::Zero();
  double level_ = 0, damping_ = 0;  // J, N·s/m
  EnergyBook book_;
};

}  // namespace prosector
