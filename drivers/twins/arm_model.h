#pragma once
// A haptic arm as mechanics, held by a modelled hand: what twins move and what benches close loops with.
//
// Translation alone: (m_a + m_h)·a = motors + hand − damping·v − Coulomb friction, all isotropic. The hand is
// a spring and a damper to where its owner wants it (Hogan 1989; Hajian & Howe 1997).

#include "common/math.h"

namespace prosector {

/// Figures of a PHANTOM Omni, as measured by others (facts of its data sheet; damping fitted).
struct ArmMechanics {
  double mass = 0.045;      // kg, apparent at the tip
  double damping = 0.05;    // N·s/m
  double friction = 0.1;    // N: Coulomb
  double quantum = 55e-6;   // m: an encoder's step at the tip
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

  /// Sets the motors' force, N. What they can't do is cut, its direction kept; what is no number is none.
  void set_force(const Vec3& force);
  /// Moves on by dt s; the hand wants to be at `intended` (m), and to move with `velocity` (m/s).
  void advance(double dt, const Vec3& intended, const Vec3& velocity);

  Vec3 measured() const;  // m: as encoders see it
  const Vec3& position() const { return position_; }
  const Vec3& velocity() const { return velocity_; }
  const Vec3& force() const { return force_; }
  /// Returns what the motors took from the hand so far, J: below 0, they gave more than they got.
  double energy() const { return energy_; }

 private:
  ArmMechanics mechanics_;
  HandImpedance hand_;
  Vec3 position_, velocity_ = Vec3::Zero(), force_ = Vec3::Zero();
  double energy_ = 0;
};

}  // namespace prosector
