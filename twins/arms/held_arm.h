#pragma once
// Mechanics of an arm in a hand whose target follows a script; the common core of all simulated arms. The
// owner advances its time.

#include <cstdint>

#include "drivers/recordings/motion_script.h"
#include "twins/arms/arm_model.h"
#include "twins/arms/wrist_model.h"
#include "twins/base/twin.h"

namespace prosector {

struct HeldArmOptions {
  MotionScript script;  // station 0: target of the stylus in the room frame
  TwinTiming timing;
  Pose room_arm;
  HandImpedance hand = medium_hand;
  bool turns = false;  // motors actuate the stylus rotation; otherwise the hand sets it directly
};

class HeldArm {
 public:
  /// Creates a simulated arm that rests at `rest` (m, arm frame) until take() makes the hand hold it.
  HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, const Vec3& rest, std::int64_t now_ns);
  /// Creates a simulated arm that rests at the first position of its motion script until take() makes the
  /// hand hold it.
  HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, std::int64_t now_ns);

  /// Makes the simulated hand hold the arm from `time_ns` on and move it to the first position of the motion
  /// script. After 0.8 s it has arrived there and the script starts.
  void take(std::int64_t time_ns);
  /// Makes the simulated hand release the arm immediately. The arm stays at its current position with the
  /// motors off.
  void put_down();
  void go_on(std::int64_t now_ns) { clock_.go_on(now_ns); }
  /// Sets the motors' force (N) and torque (N·m) on the stylus, arm frame. While no hand holds the arm, both
  /// are zero instead.
  void set_force(const Vec3& force, const Vec3& torque = Vec3::Zero());
  void advance(std::int64_t now_ns);

  bool taken() const { return taken_; }
  bool turns() const { return options_.turns; }
  const ArmModel& model() const { return model_; }    // in the arm frame
  Vec3 intended() const { return intended_; }         // m, arm frame: target position of the hand
  const WristModel& wrist() const { return wrist_; }  // used if motors actuate the stylus rotation
  /// Returns the stylus orientation in the arm frame: as measured if motors actuate the rotation, otherwise
  /// as the motion script prescribes.
  Quat orientation() const { return options_.turns ? wrist_.measured() : intended_turn(); }
  const Pose& room_arm() const { return options_.room_arm; }

 private:
  struct Wish {
    Vec3 place, velocity;
  };
  Vec3 scripted(double seconds) const;
  Wish wish() const;
  Quat intended_turn() const;

  HeldArmOptions options_;
  ScriptClock clock_;
  std::int64_t now_ns_, taken_ns_ = 0;
  Vec3 rest_;
  ArmModel model_;
  WristModel wrist_;
  bool taken_ = false;
  Vec3 intended_;
};

}  // namespace prosector
