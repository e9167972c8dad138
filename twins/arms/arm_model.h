#pragma once
// Mechanical model of a haptic arm in a modelled hand, for twins and for benchmarks that close control loops.
//
// Translation only: (m_a + m_h)·a = motors + hand − damping·v − Coulomb friction, all isotropic. The hand is
// a spring and damper to its intended position (Hogan 1989; Hajian & Howe 1997).

#include "common/math.h"

namespace prosector {

/// Mechanical parameters of a simulated haptic arm. The defaults are those of a PHANTOM Omni, from published
/// measurements and its data sheet; the damping is fitted.
struct ArmMechanics {
  double mass = 0.045;      // kg, apparent at the tip
  double damping = 0.05;    // N·s/m
  double friction = 0.1;    // N: Coulomb
  double quantum = 55e-6;   // m: resolution of an encoder at the tip
  double peak_force = 3.3;  // N, of the motors
};

struct HandImpedance {
  double mass = 0.03;     // kg
  double damping = 1;     // N·s/m
  double stiffness = 60;  // N/m
};
inline constexpr HandImpedance light_hand{0.03, 1, 60}, medium_hand{0.1, 3, 200};

class ArmModel {
 public:
  ArmModel(const ArmMechanics& mechanics, const HandImpedance& hand, const Vec3& start)
      : mechanics_(mechanics), hand_(hand), position_(start) {}

  /// Sets the force of the arm's motors, N. A force above the peak is scaled down without changing its
  /// direction; a force that is not finite becomes zero.
  void set_force(const Vec3& force);
  /// Advances the arm and the hand that holds it by dt s. The position that the hand aims at is `intended`
  /// (m) at the end of this time and moves with `velocity` (m/s).
  void advance(double dt, const Vec3& intended, const Vec3& velocity);

  Vec3 measured() const;  // m: position quantised as by encoders
  const Vec3& position() const { return position_; }
  const Vec3& velocity() const { return velocity_; }
  const Vec3& force() const { return force_; }
  /// Returns the energy that the arm's motors have absorbed from the hand since the start, J. It is negative
  /// if they delivered net energy.
  double energy() const { return energy_; }

 private:
  ArmMechanics mechanics_;
  HandImpedance hand_;
  Vec3 position_, velocity_ = Vec3::Zero(), force_ = Vec3::Zero();
  double energy_ = 0;
};

}  // namespace prosector
