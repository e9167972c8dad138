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
  explicit HapticLoop(const ArmLimits& limits, Safeguards safeguards = {})
      : guard_(limits), safeguards_(safeguards) {}

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
  const Vec3& force() const { return force_; }
  /// Returns by how much that force falls along a way of the hand, N/m, room frame.
  const Mat3& stiffness() const { return stiffness_; }

 private:
  void follow(const Pose& stylus, double dt);

  PlaneSet planes_;
  Passivity passivity_;
  ForceGuard guard_;
  Safeguards safeguards_;
  bool known_ = false;  // the last reading was valid
  double time_ = 0;     // s, of the last cycle
  Pose hand_;
  Vec3 velocity_ = Vec3::Zero(), slow_velocity_ = Vec3::Zero();  // m/s, filtered, the second more
  Vec3 force_ = Vec3::Zero();                                    // N, that acts
  Mat3 stiffness_ = Mat3::Zero();
};

}  // namespace prosector
