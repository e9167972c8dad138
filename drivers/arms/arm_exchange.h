#pragma once
// Exchange between the servo thread and the device thread of an arm that has its own thread: samples in one
// direction, forces in the other. Old values expire, so that no force persists when a thread hangs.

#include <cstdint>

#include "drivers/device/arm.h"
#include "drivers/device/plausible.h"
#include "drivers/ports/triple_buffer.h"

namespace prosector {

/// State of a haptic arm that the thread communicating with the device publishes for the servo thread: a
/// reading, a condition to report, and counts.
struct ArmSample {
  std::int64_t time_ns = 0;  // driver's clock; 0: no sample yet
  ArmReading reading;        // the stylus pose is in the arm frame, not the room frame
  std::uint32_t jumps = 0;   // number of pose jumps, such as those of a calibration
  int condition = 0;         // driver-specific condition to report to the user; 0: none
  int code = 0;              // API error code for that condition
  std::uint64_t records = 0, bad = 0;
};

class ArmExchange {
 public:
  static constexpr std::int64_t quiet_ns = 20'000'000;             // expiry time of samples and forces
  static constexpr std::int64_t silence_timeout_ns = 500'000'000;  // time without samples after which the arm
                                                                   // is reopened

  // Called by the device thread:
  void publish(const ArmSample& sample) { samples_.write(sample); }
  /// Returns the force that the device thread must apply to the hand, N, room frame. It is zero if the servo
  /// thread has set none in the last 20 ms.
  Vec3 force(std::int64_t now_ns);

  // Called by the servo thread:
  /// Returns the arm's latest reading in the room frame; `room_arm` is the pose of the arm frame in the room.
  /// The reading is not valid if it is older than 20 ms or the pose jumped since the last call.
  ArmReading reading(std::int64_t now_ns, const Pose& room_arm);
  /// Sets the force that the arm shall exert on the hand, N, room frame, shortened to the arm's peak force
  /// `most`. It expires 20 ms after `now_ns`.
  void set_force(const Vec3& force, double most, std::int64_t now_ns) {
    forces_.write({bounded_force(force, most), now_ns});
  }
  const ArmSample& sample() { return samples_.read(); }
  /// Returns whether no sample has arrived from the arm for `silence_timeout_ns`. Counts from the last
  /// sample, or from `opened_ns` if that is later.
  bool silent(std::int64_t now_ns, std::int64_t opened_ns);

 private:
  struct TimedForce {
    Vec3 force = Vec3::Zero();
    std::int64_t time_ns = 0;
  };
  TripleBuffer<ArmSample> samples_;
  TripleBuffer<TimedForce> forces_;
  std::uint32_t jumps_ = 0;  // jump count at the servo's last reading
};

}  // namespace prosector
