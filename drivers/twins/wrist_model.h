#pragma once
// How a stylus turns in a modelled hand, where motors turn it: I·α = motors + hand − damping·ω − Coulomb
// friction, all isotropic. The hand is to turns what it is to ways at a lever: each figure times its square.

#include "drivers/twins/arm_model.h"

namespace prosector {

/// Inertia, damping and friction are assumed; peak and quantum are of the sigma.7's data sheet.
struct WristMechanics {
  double inertia = 1e-4;     // kg·m²
  double damping = 1e-4;     // N·m·s/rad
  double friction = 2e-3;    // N·m: Coulomb
  double quantum = 2.3e-4;   // rad: an encoder's step
  double peak_torque = 0.4;  // N·m, of the motors
};
inline constexpr double hand_lever = 0.05;  // m: how far apart fingers hold a stylus

class WristModel {
 public:
  WristModel(const WristMechanics& mechanics, const HandImpedance& hand, const Quat& start)
      : mechanics_(mechanics), hand_(hand), orientation_(start) {}

  /// Sets the motors' torque, N·m. What they can't do is cut, its direction kept; what is no number is none.
  void set_torque(const Vec3& torque);
  /// Moves on by dt s; the hand wants to be turned as `intended`.
  void advance(double dt, const Quat& intended);

  Quat measured() const;  // as encoders see it
  const Quat& orientation() const { return orientation_; }
  const Vec3& torque() const { return torque_; }
  /// Returns what the motors took from the hand so far, J: below 0, they gave more than they got.
  double energy() const { return energy_; }

 private:
  WristMechanics mechanics_;
  HandImpedance hand_;
  Quat orientation_;
  Vec3 spin_ = Vec3::Zero(), torque_ = Vec3::Zero();
  double energy_ = 0;
};

}  // namespace prosector
