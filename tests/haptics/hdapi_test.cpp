// The driver of OpenHaptics' arms, at a library with the same functions.
#include "drivers/arms/hdapi.h"

#include "tests/haptics/library_arm_case.h"

namespace prosector {
namespace {

class HdapiDriver : public LibraryArmCase<HdapiArm> {
 protected:
  HdapiDriver() : LibraryArmCase("default", "libHD.so") {}
};

TEST_F(HdapiDriver, APlaneIsFeltAsStiffAsItIs) {
  for (const double stiffness : {300., 1000.}) {
    arm_.reset();
    twin_.restart(pressing_hand(), now_ns_, 1);
    arm_ = open(address_);
    expect_felt(pressed(stiffness), stiffness);
  }
}

TEST_F(HdapiDriver, ReadsPlaceTurnAndButtons) {
  twin_.faults.buttons = 2;
  const ArmReading reading = go(1);
  expect_there(reading);
  EXPECT_EQ(reading.buttons, 2u);
  EXPECT_FALSE(reading.hot);
  EXPECT_EQ(arm_->status().health, DeviceHealth::streaming);
  EXPECT_EQ(message(), "");
}

TEST_F(HdapiDriver, NothingIsValidUntilItKnowsWhereItIs) {
  for (int k = 0; k < 100 && !go(1e-3, {1, 0, 0}).valid; ++k) {
    EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero());
  }
  expect_there(go(1));
  twin_.faults.needs_calibration = true;
  EXPECT_FALSE(go(1e-3, {1, 0, 0}).valid) << "its pose jumps";
  EXPECT_FALSE(twin_.faults.needs_calibration) << "it was calibrated anew";
  expect_there(go(0.1));
}

TEST_F(HdapiDriver, ForceGoesWhereItIsSentAndEndsWithTheServo) {
  go(1.5, {0.5, 0, 0.3});
  const Vec3 acts = twin_.arm()->room_arm().q * twin_.arm()->model().force();
  EXPECT_NEAR((acts - Vec3(0.5, 0, 0.3)).norm(), 0, 1e-9);
  // The client's servo hangs; HDAPI's goes on.
  for (int k = 0; k < 30; ++k) twin_.advance(now_ns_ += ms);
  EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero());
}

TEST_F(HdapiDriver, WarmMotorsAreToldHoweverTheyAreSaid) {
  go(1);
  twin_.faults.temperature = 0.95;
  EXPECT_TRUE(go(0.01).hot);
  EXPECT_TRUE(says("hot"));
  twin_.faults.temperature = 0.2;
  EXPECT_FALSE(go(0.01).hot);
  twin_.faults.force_error = hdapi::warm_motors;
  const ArmReading reading = go(0.01);
  EXPECT_TRUE(reading.hot);
  EXPECT_TRUE(reading.valid);
}

TEST_F(HdapiDriver, AForceThatIsRefusedBeginsAtNothingAgain) {
  go(1);
  twin_.faults.force_error = hdapi::exceeded_max_force;
  EXPECT_FALSE(go(0.01, {1, 0, 0}).valid);
  EXPECT_TRUE(says("rejected")) << message();
  EXPECT_TRUE(says("0201")) << message();
  twin_.faults.force_error = 0;
  expect_there(go(0.01));
  EXPECT_EQ(arm_->status().reopens, 0u) << "it passes";
}

TEST_F(HdapiDriver, UnpluggedItIsLostAndComesBackByItself) {
  go(1, {1, 0, 0});
  twin_.faults.away = true;
  EXPECT_FALSE(go(0.01, {1, 0, 0}).valid);
  go(1, {1, 0, 0});
  EXPECT_EQ(arm_->status().health, DeviceHealth::absent);
  EXPECT_TRUE(says("cannot be opened")) << message();
  EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero());
  twin_.faults.away = false;
  expect_there(go(2));
  EXPECT_EQ(arm_->status().reopens, 1u);
}

TEST_F(HdapiDriver, ErrorsWithoutEndAreNoEndlessLoop) {
  go(1);
  twin_.faults.error = hdapi::frame_error;
  EXPECT_FALSE(go(0.01).valid);
  go(1);
  EXPECT_EQ(arm_->status().health, DeviceHealth::absent);
  EXPECT_TRUE(says("0402")) << message();
  twin_.faults.error = 0;
  expect_there(go(2));
}

TEST_F(HdapiDriver, AServoThatStandsStillIsNoticed) {
  go(1);
  const auto wait = [&](int cycles) {
    ArmReading out;
    for (int k = 0; k < cycles; ++k) {
      now_ns_ += ms;
      out = arm_->read();
    }
    return out;
  };
  EXPECT_FALSE(wait(25).valid);
  wait(600);
  EXPECT_TRUE(says("has stopped")) << message();
  expect_there(go(2));
}

TEST_F(HdapiDriver, SaysWhichLibraryItLookedFor) {
  arm_ = open("default");
  EXPECT_FALSE(go(0.01).valid);
  EXPECT_EQ(arm_->status().health, DeviceHealth::absent);
  EXPECT_TRUE(says("'libHD.so'")) << message();
  arm_ = open("default@/nonexistent/libHD.so");
  go(0.01);
  EXPECT_TRUE(says("'/nonexistent/libHD.so'")) << message();
}

TEST_F(HdapiDriver, SaysWhichFunctionAnotherLibraryLacks) {
  arm_ = open("default@" + twin_library("libdhd.so"));
  EXPECT_FALSE(go(0.01).valid);
  EXPECT_TRUE(says("hdInitDevice")) << message();
  EXPECT_TRUE(says("libdhd.so")) << message();
}

TEST_F(HdapiDriver, RefusesAVersionThatIsNotKnown) {
  twin_.faults.version = 9;
  EXPECT_FALSE(go(0.01).valid);
  EXPECT_TRUE(says("version '9.1'")) << message();
}

TEST_F(HdapiDriver, GarbageIsNeverWhereAHandIs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    arm_.reset();
    twin_.restart(pressing_hand(), now_ns_, seed);
    arm_ = open(address_);
    int valid = 0;
    go(0.1);
    twin_.faults.garbage = 0.01;  // of 20 numbers a reading
    for (int k = 0; k < 2000; ++k) {
      const ArmReading reading = go(1e-3, {1, 0, 0});
      if (!reading.valid) continue;
      ++valid;
      ASSERT_TRUE(reading.stylus.p.allFinite());
      ASSERT_LT((reading.stylus.p - twin_.arm()->room_arm().p).norm(), 2.1);
      ASSERT_TRUE(twin_.arm()->model().position().allFinite());
    }
    EXPECT_GT(valid, 200) << "what is good among it still counts";
    EXPECT_EQ(arm_->status().reopens, 0u);
  }
}

}  // namespace
}  // namespace prosector
