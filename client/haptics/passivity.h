#pragma once
// Prevents the arm from delivering more energy to the hand than was put in. Passivity observer and controller
// in the time domain (Hannaford & Ryu 2002, "Time-domain passivity control of haptic interfaces", IEEE Trans.
// Robotics and Automation 18). Delay, lost messages or a wrong stiffness estimate would otherwise create
// energy.
//
// Forces are held between cycles, so the energy is known exactly: last force times displacement plus last
// torque times rotation.

#include "client/haptics/hand_motion.h"

namespace prosector {

/// Energy exchanged between arm and hand since the start, J. Both sums only increase.
struct EnergyBook {
  double taken = 0;  // from the hand
  double given = 0;  // to the hand
};

class Passivity {
 public:
  /// Updates the energy balance by the work of the last force and torque over the displacement of their point
  /// of application to `stylus`, room frame. `stored`: energy now stored in the contact springs, J, which the
  /// hand can regain. `surroundings`: power supplied by other users and bodies, W. `dt`: s since the last
  /// call.
  void observe(const Pose& stylus, double stored, double surroundings, double dt);
  /// Returns the wanted force and torque plus damping that dissipates the excess energy delivered to the
  /// hand. The damping is limited to what arms render stably. `motion`: velocity of the point of application;
  /// without spin if the arm has no torque. Scaling the force down instead causes a limit cycle at 3 kN/m
  /// (docs/decisions).
  Wrench damp(const Wrench& wanted, const HandMotion& motion, double dt);
  /// Sets the force and torque that act on the hand from now on, whose work the next observe() counts.
  void applied(const Wrench& wrench) { acts_ = wrench; }
  /// Discards the last stylus pose, for instance after a missing reading: the next displacement is then
  /// unknown, and its work is not counted.
  void interrupt() { known_ = false; }

  const EnergyBook& book() const { return book_; }
  double level() const { return level_; }  // J: energy that the hand put in and did not regain

 private:
  bool known_ = false;
  Pose stylus_;
  Wrench acts_;
  double level_ = 0, damping_ = 0;  // J, N·s/m
  EnergyBook book_;
};

}  // namespace prosector
