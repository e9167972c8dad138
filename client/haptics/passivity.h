#pragma once
// Keeps the arm from giving a hand energy that nobody put in: a passivity observer and controller in time
// (Hannaford & Ryu 2002, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
// Automation 18). Delay, lost messages or a wrong estimate of stiffness would.
//
// Forces are held between cycles, so the energy is known exactly: F of the last cycle times the way since,
// and its torque times the turn.

#include "client/haptics/hand_motion.h"

namespace prosector {

/// What went through the hand since the arm was taken up, J. Both only grow.
struct EnergyBook {
  double taken = 0;  // from the hand
  double given = 0;  // to the hand
};

class Passivity {
 public:
  /// Counts what the last cycle's force did on the way to `stylus`, where it acts. `stored`: what the
  /// contacts hold now as springs, J, which the hand gets back. `surroundings`: W, that others give.
  void observe(const Pose& stylus, double stored, double surroundings, double dt);
  /// Returns what acts with as much damping as spends what the hand got too much, within what arms bear.
  /// `motion`: of where it acts; no spin where the arm has no torque.
  /// Cutting the force instead makes it chatter: a limit cycle at 3 kN/m (docs/decisions).
  Wrench damp(const Wrench& wanted, const HandMotion& motion, double dt);
  /// Tells what acts from now on.
  void applied(const Wrench& wrench) { acts_ = wrench; }
  /// Forgets where the hand was: nothing is known of the way it takes meanwhile.
  void interrupt() { known_ = false; }

  const EnergyBook& book() const { return book_; }
  double level() const { return level_; }  // J: what the hand put in and did not get back

 private:
  bool known_ = false;
  Pose stylus_;
  Wrench acts_;
  double level_ = 0, damping_ = 0;  // J, N·s/m
  EnergyBook book_;
};

}  // namespace prosector
