// The servo's thread with an arm of a test's own; wall-clock time is never judged.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "client/haptics/servo_thread.h"
#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

/// What the test sees of the arm while the thread has it.
struct Seen {
  std::atomic<std::uint64_t> reads = 0;
  std::atomic<std::uint32_t> buttons = 0;
  std::atomic<double> force = 0, last = -1;
};

class StillArm final : public Arm {
 public:
  explicit StillArm(Seen& seen) : seen_(seen) {}
  const ArmLimits& limits() const override { return limits_; }
  ArmReading read() override {
    ++seen_.reads;
    ArmReading out;
    out.valid = true;
    out.stylus.p = {0, -0.002, 0};
    out.buttons = seen_.buttons;
    return out;
  }
  void set_force(const Vec3& force) override {
    seen_.force = std::max(seen_.force.load(), force.norm());
    seen_.last = force.norm();
  }
  DeviceStatus status() const override { return {}; }

 private:
  Seen& seen_;
  ArmLimits limits_ = omni_limits();
};

std::vector<ContactPlane> floor_below() {
  std::vector<ContactPlane> planes(1);
  planes[0].id = 1;
  planes[0].stiffness = planes[0].tangential = 500;
  return planes;
}

TEST(ServoThread, RendersWhatItIsTold) {
  Seen seen;
  {
    ServoThread servo(std::make_unique<StillArm>(seen), Pose());
    for (int k = 0; k < 1000 && seen.force < 0.5; ++k) {
      servo.feel(floor_below());
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_GE(seen.force, 0.5);
    EXPECT_GT(servo.lateness().cycles, 0u);
    EXPECT_TRUE(servo.view().reading.valid);
  }
  EXPECT_EQ(seen.last, 0) << "the arm is left without force";
}

TEST(ServoThread, WithoutItsDeadMansButtonNothingIsFelt) {
  Seen seen;
  seen.buttons = 1;  // another one
  ServoThread servo(std::make_unique<StillArm>(seen), Pose(), 2);
  const auto feel_for = [&](std::uint64_t cycles) {
    const std::uint64_t until = seen.reads + cycles;
    while (seen.reads < until) {
      servo.feel(floor_below());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  };
  feel_for(100);
  EXPECT_EQ(seen.force, 0);
  seen.buttons = 3;
  for (int k = 0; k < 200 && seen.force < 0.5; ++k) feel_for(10);
  EXPECT_GE(seen.force, 0.5);
  seen.buttons = 1;
  feel_for(200);
  EXPECT_EQ(seen.last, 0) << "let go";
}

TEST(ServoThread, NothingToldIsNothingFelt) {
  Seen seen;
  ServoThread servo(std::make_unique<StillArm>(seen), Pose());
  while (seen.reads < 100) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(seen.force, 0);
}

}  // namespace
}  // namespace prosector
