#pragma once
// One cycle of the servo loop: computes a force from a reading of the arm. It reads no clock, so tests run it
// in simulated time; servo_thread.h calls it a thousand times a second.

#include <span>

#include "client/haptics/force_guard.h"
#include "client/haptics/passivity.h"
#include "client/haptics/plane_set.h"

namespace prosector {

/// Safeguards of the servo loop that tests can disable to measure their effect. They are always on otherwise.
struct Safeguards {
  bool prediction = true;  // forces are evaluated at the middle of the cycle in which they act
  bool passivity = true;   // damping while there is an energy deficit
};

class HapticLoop {
 public:
  /// Creates the servo loop of an arm with these limits. `grip`: the stylus point at which force and torque
  /// act, m, hand frame.
  explicit HapticLoop(const ArmLimits& limits, Safeguards safeguards = {}, const Vec3& grip = Vec3::Zero());

  /// Replaces the contact planes (local linear models of the contact forces) by those of a newly received
  /// message. `time`: time of the next cycle, s, servo clock.
  void take(std::span<const ContactPlane> planes, double time);
  /// Records that the server repeated its newest message of contact planes at `time` (s, servo clock). The
  /// planes are unchanged, but the connection counts as alive.
  void repeat_received(double time) { planes_.repeat_received(time); }
  /// Computes one servo cycle: returns the force to apply to the hand, N, room frame, for a reading of the
  /// arm. `time`, s, must increase from call to call. While `allowed` is false the force fades to zero; it
  /// ramps up slowly afterwards.
  Vec3 cycle(const ArmReading& reading, double time, bool allowed = true);

  const EnergyBook& energy() const { return passivity_.book(); }
  double energy_level() const { return passivity_.level(); }
  const GuardCounts& guard() const { return guard_.counts(); }
  /// Returns the hand's room pose in the last valid reading; force() returns the force of the last cycle, N,
  /// room frame.
  const Pose& hand() const { return hand_; }
  const Vec3& force() const { return acts_.force; }
  /// Returns the torque of the last cycle about the stylus point, N·m, room frame; zero if the arm has no
  /// torque motors.
  const Vec3& torque() const { return acts_.torque; }
  /// Returns the stiffness of the last cycle's force with respect to displacements of the hand, N/m, room
  /// frame. It is scaled down by the same factor as a force that exceeds the limits.
  const Mat3& stiffness() const { return stiffness_; }

 private:
  void follow(const Pose& hand, double dt);
  void forget_motion();
  Pose stylus() const { return {hand_ * grip_, hand_.q}; }
  Wrench shown(const FeltWrench& felt, bool turns) const;

  PlaneSet planes_;
  Passivity passivity_;
  ForceGuard guard_, torque_guard_;
  Safeguards safeguards_;
  Vec3 grip_;
  double torsion_;      // N·m/rad: maximum torsional stiffness that the arm can render
  bool known_ = false;  // the last reading was valid
  double time_ = 0;     // s, of the last cycle
  Pose hand_;
  HandMotion motion_, slow_motion_;  // filtered: of the hand, and with a lower cutoff of the stylus point
  Wrench acts_;
  Mat3 stiffness_ = Mat3::Zero();
};

}  // namespace prosector
