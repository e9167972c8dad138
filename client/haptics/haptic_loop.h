#pragma once
// One cycle of the servo loop: a reading of the arm becomes a force. It reads no clock, so it runs in tests'
// own time as well; servo_thread.h calls it a thousand times a second.

#include <span>

#include "client/haptics/force_guard.h"
#include "client/haptics/passivity.h"
#include "client/haptics/plane_set.h"

namespace prosector {

/// What can be left out to measure what it is for; nothing else leaves it out.
struct Safeguards {
  bool prediction = true;  // forces are those in the middle of the cycle in which they act
  bool passivity = true;   // damping where energy is missing
};

class HapticLoop {
 public:
  /// Makes a loop. `grip`: the stylus' point, m, in the hand's frame, where force acts, and torque about it.
  explicit HapticLoop(const ArmLimits& limits, Safeguards safeguards = {}, const Vec3& grip = Vec3::Zero());

  /// Takes a message's planes, before the cycle at `time` (s, of the servo's clock).
  void take(std::span<const ContactPlane> planes, double time);
  /// Notes that the newest message came once more.
  void heard_again(double time) { planes_.heard_again(time); }
  /// Returns the force for the arm, N, room frame. `time` rises from call to call. Unless it is `allowed`,
  /// force fades, and comes back slowly once it is.
  Vec3 cycle(const ArmReading& reading, double time, bool allowed = true);

  const EnergyBook& energy() const { return passivity_.book(); }
  double energy_level() const { return passivity_.level(); }
  const GuardCounts& guard() const { return guard_.counts(); }
  /// Returns the hand's pose and the force of the last cycle.
  const Pose& hand() const { return hand_; }
  const Vec3& force() const { return acts_.force; }
  /// Returns the torque of the last cycle about the stylus' point, N·m, room frame; none where motors don't
  /// turn it.
  const Vec3& torque() const { return acts_.torque; }
  /// Returns by how much that force falls along a way of the hand, N/m, room frame.
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
  double torsion_;      // N·m/rad: of the hardest turn that the arm shows
  bool known_ = false;  // the last reading was valid
  double time_ = 0;     // s, of the last cycle
  Pose hand_;
  HandMotion motion_, slow_motion_;  // filtered: of the hand, and more so of the stylus' point
  Wrench acts_;
  Mat3 stiffness_ = Mat3::Zero();
};

}  // namespace prosector
