#pragma once
// What crosses between the servo's thread and the thread at the arm, where these are two: samples one way,
// forces the other. What is old counts for nothing, so that no thread that hangs leaves a force behind.

#include <cstdint>

#include "drivers/arm.h"
#include "drivers/newest.h"
#include "drivers/plausible.h"

namespace prosector {

/// What the thread at the arm knows.
struct ArmSample {
  std::int64_t time_ns = 0;  // of the driver's clock; 0: there is none yet
  ArmReading reading;        // its stylus is in the arm's frame, not in the room
  std::uint32_t jumps = 0;   // how often the pose jumped, as calibration lets it
  int condition = 0;         // what people are to be told of, in the driver's own numbers; 0: nothing
  int code = 0;              // … and the API's number for it
  std::uint64_t records = 0, bad = 0;
};

class ArmExchange {
 public:
  static constexpr std::int64_t quiet_ns = 20'000'000;    // after which what was said counts no more
  static constexpr std::int64_t silent_ns = 500'000'000;  // after which the arm is to be opened anew

  // The thread at the arm calls:
  void tell(const ArmSample& sample) { samples_.write(sample); }
  /// Returns the force to set, N, room frame.
  Vec3 force(std::int64_t now_ns);

  // The servo's thread calls:
  /// Returns the newest reading, in the room. It isn't valid when it is old, or the pose jumped since the
  /// last call.
  ArmReading reading(std::int64_t now_ns, const Pose& room_arm);
  /// Sets the force, N, room frame; `most`: the arm's peak force.
  void set_force(const Vec3& force, double most, std::int64_t now_ns) {
    forces_.write({bounded_force(force, most), now_ns});
  }
  const ArmSample& sample() { return samples_.read(); }
  /// Tells whether nothing came for long. `opened_ns`: since when something could.
  bool silent(std::int64_t now_ns, std::int64_t opened_ns);

 private:
  struct TimedForce {
    Vec3 force = Vec3::Zero();
    std::int64_t time_ns = 0;
  };
  Newest<ArmSample> samples_;
  Newest<TimedForce> forces_;
  std::uint32_t jumps_ = 0;  // that the servo knows of
};

}  // namespace prosector
