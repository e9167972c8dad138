#pragma once
// What all simulated arms have behind their bytes: an arm's mechanics, in a hand that wants to be where a
// script says. It runs in the time that its owner gives it.

#include <cstdint>

#include "drivers/motion_script.h"
#include "drivers/twins/arm_model.h"
#include "drivers/twins/twin.h"
#include "drivers/twins/wrist_model.h"

namespace prosector {

struct HeldArmOptions {
  MotionScript script;  // station 0: where the hand wants the stylus, in the room
  TwinTiming timing;
  Pose room_arm;
  HandImpedance hand = medium_hand;
  bool turns = false;  // motors turn the stylus, too; else the hand turns it freely
};

class HeldArm {
 public:
  /// Makes an arm that lies at `rest` (m, arm's frame) until it is taken.
  HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, const Vec3& rest, std::int64_t now_ns);
  /// Makes an arm that lies where the script begins.
  HeldArm(HeldArmOptions options, const ArmMechanics& mechanics, std::int64_t now_ns);

  /// Lets the hand take it at that time. 0.8 s later it is where the script begins, and the script starts.
  void take(std::int64_t time_ns);
  /// Lets the hand put it down where it is, at once, without motors.
  void put_down();
  void go_on(std::int64_t now_ns) { clock_.go_on(now_ns); }
  /// Sets the motors' force (N) and torque (N·m), arm's frame. One that lies has none.
  void set_force(const Vec3& force, const Vec3& torque = Vec3::Zero());
  void advance(std::int64_t now_ns);

  bool taken() const { return taken_; }
  bool turns() const { return options_.turns; }
  const ArmModel& model() const { return model_; }    // in the arm's frame
  Vec3 intended() const { return intended_; }         // m, arm's frame: where the hand wants it
  const WristModel& wrist() const { return wrist_; }  // of an arm whose motors turn the stylus
  /// Returns how the stylus is turned, arm's frame.
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
