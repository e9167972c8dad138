#pragma once
// Rotation of an actuated stylus in a modelled hand: I·α = motors + hand − damping·ω − Coulomb friction, all
// isotropic. The hand's rotational mass, damping and stiffness are its translational values times the squared
// lever arm.

#include "twins/arms/arm_model.h"

namespace prosector {

/// Mechanical parameters of a simulated stylus whose rotation motors actuate. Inertia, damping and friction
/// are assumed; peak torque and quantum are from the sigma.7's data sheet.
struct WristMechanics {
  double inertia = 1e-4;     // kg·m²
  double damping = 1e-4;     // N·m·s/rad
  double friction = 2e-3;    // N·m: Coulomb
  double quantum = 2.3e-4;   // rad: resolution of an encoder
  double peak_torque = 0.4;  // N·m, of the motors
};
inline constexpr double hand_lever = 0.05;  // m: lever arm of the fingers on the stylus

class WristModel {
 public:
  WristModel(const WristMechanics& mechanics, const HandImpedance& hand, const Quat& start)
      : mechanics_(mechanics), hand_(hand), orientation_(start) {}

  /// Sets the torque of the stylus' motors, N·m. A torque above the peak is scaled down without changing its
  /// direction; a torque that is not finite becomes zero.
  void set_torque(const Vec3& torque);
  /// Advances the stylus and the hand that holds it by dt s. `intended` is the orientation that the hand aims
  /// at.
  void advance(double dt, const Quat& intended);

  Quat measured() const;  // orientation quantised as by encoders
  const Quat& orientation() const { return orientation_; }
  const Vec3& torque() const { return torque_; }
  /// Returns the energy that the stylus' motors have absorbed from the hand since the start, J. It is
  /// negative if they delivered net energy.
  double energy() const { return energy_; }

 private:
  WristMechanics mechanics_;
  HandImpedance hand_;
  Quat orientation_;
  Vec3 spin_ = Vec3::Zero(), torque_ = Vec3::Zero();
  double energy_ = 0;
};

}  // namespace prosector
