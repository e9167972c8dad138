// The driver of Force Dimension's arms, at a library with the same functions.
#include "drivers/arms/dhd.h"

#include <limits>

#include "common/rotation.h"
#include "tests/haptics/library_arm_case.h"

namespace prosector {
namespace {

class DhdDriver : public LibraryArmCase<DhdArm> {
 protected:
  DhdDriver() : LibraryArmCase("0", "libdhd.so") {}
};

TEST_F(DhdDriver, APlaneIsFeltAsStiffAsItIs) {
  for (const double stiffness : {300., 1000.}) {
    arm_.reset();
    twin_.restart(pressing_hand(), now_ns_, 1);
    arm_ = open(address_);
    expect_felt(pressed(stiffness), stiffness);
  }
}

TEST_F(DhdDriver, ReadsPlaceTurnAndButtons) {
  twin_.faults.buttons = 1;
  const ArmReading reading = go(1);
  expect_there(reading);
  EXPECT_EQ(reading.buttons, 1u);
  EXPECT_EQ(arm_->status().health, DeviceHealth::streaming);
  EXPECT_EQ(message(), "");
}

TEST_F(DhdDriver, AGrippersClosingCountsAsAButton) {
  arm_.reset();
  twin_.faults.gripper = true;
  twin_.faults.buttons = 1;
  arm_ = open(address_);
  EXPECT_EQ(go(1).buttons, 1u);
}

TEST_F(DhdDriver, TheFirstOneIsTheUsualOne) {
  arm_ = open("default@" + library_);
  expect_there(go(1));
}

TEST_F(DhdDriver, ForceGoesWhereItIsSent) {
  go(1, {0.5, 0, 0.3});
  const Vec3 acts = twin_.arm()->room_arm().q * twin_.arm()->model().force();
  EXPECT_NEAR((acts - Vec3(0.5, 0, 0.3)).norm(), 0, 1e-9);
  arm_.reset();
  EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero());
}

TEST_F(DhdDriver, TorqueGoesWhereItIsSentAndTurnsTheStylus) {
  HeldArmOptions turning = pressing_hand();
  turning.turns = true;
  arm_.reset();
  twin_.restart(turning, now_ns_, 1);
  arm_ = open(address_);
  EXPECT_TRUE(go(1).turns);
  const HeldArm& held = *twin_.arm();
  const Quat before = held.room_arm().q * held.orientation();
  const Vec3 torque(0.02, 0.01, -0.03);
  arm_->set_torque(torque);
  expect_there(go(1, {0.5, 0, 0.3}));
  EXPECT_NEAR((held.room_arm().q * held.wrist().torque() - torque).norm(), 0, 1e-9);
  EXPECT_NEAR((held.room_arm().q * held.model().force() - Vec3(0.5, 0, 0.3)).norm(), 0, 1e-9);
  // A medium hand holds 0.5 N·m/rad; friction takes 2 mN·m of what turns.
  const Vec3 turned = turn(before, held.room_arm().q * held.orientation());
  EXPECT_NEAR((0.5 * turned - torque).norm(), 0, 0.0021 + 1e-3);
  arm_->set_torque({0, std::numeric_limits<double>::quiet_NaN(), 0});
  go(0.01);
  EXPECT_EQ(held.wrist().torque(), Vec3::Zero());
}

TEST_F(DhdDriver, WithoutMotorsThatTurnItHasNoTorque) {
  EXPECT_FALSE(go(1).turns);
  arm_->set_torque({0.1, 0, 0});
  go(0.1, {0.5, 0, 0});
  EXPECT_EQ(twin_.arm()->wrist().torque(), Vec3::Zero());
}

TEST_F(DhdDriver, WhileItIsCalibratedItIsNowhere) {
  go(1);
  twin_.faults.needs_calibration = true;
  EXPECT_FALSE(go(0.1, {1, 0, 0}).valid);
  EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero());
  EXPECT_TRUE(says("rest position")) << message();
  twin_.faults.needs_calibration = false;
  expect_there(go(0.1));
}

TEST_F(DhdDriver, ForcesThatWereOffBeginAtNothing) {
  go(1, {1, 0, 0});
  twin_.faults.forces_off = true;
  EXPECT_TRUE(go(0.1, {1, 0, 0}).valid) << "its place is known";
  EXPECT_TRUE(says("forces are off")) << message();
  twin_.faults.forces_off = false;
  int lost = 0;
  for (int k = 0; k < 100; ++k) {
    lost += go(1e-3, {1, 0, 0}).valid ? 0 : 1;
    if (lost == 0) {
      EXPECT_EQ(twin_.arm()->model().force(), Vec3::Zero()) << "nothing comes before it is known";
    }
  }
  EXPECT_EQ(lost, 1) << "so that the loop begins anew";
}

TEST_F(DhdDriver, UnpluggedItIsLostAndComesBackByItself) {
  go(1);
  twin_.faults.away = true;
  EXPECT_FALSE(go(0.01).valid);
  go(1);
  EXPECT_EQ(arm_->status().health, DeviceHealth::absent);
  EXPECT_TRUE(says("cannot be opened")) << message();
  twin_.faults.away = false;
  expect_there(go(2));
  EXPECT_EQ(arm_->status().reopens, 1u);
}

TEST_F(DhdDriver, ErrorsOfEachCallAreALoss) {
  go(1);
  twin_.faults.error = -1;
  EXPECT_FALSE(go(0.01).valid);
  go(1);
  EXPECT_EQ(arm_->status().health, DeviceHealth::absent);
  twin_.faults.error = 0;
  expect_there(go(2));
}

TEST_F(DhdDriver, ForcesThatAreNeverTakenAreALoss) {
  go(1);
  twin_.faults.force_error = -1;
  go(0.2);
  EXPECT_EQ(arm_->status().reopens, 1u);
  twin_.faults.force_error = 2;
  expect_there(go(2));
  EXPECT_EQ(arm_->status().reopens, 1u) << "saturated motors are none";
}

TEST_F(DhdDriver, SaysWhatIsWrongWithLibraryOrDevice) {
  arm_ = open("0");
  go(0.01);
  EXPECT_TRUE(says("'libdhd.so'")) << message();
  arm_ = open("0@" + twin_library("libHD.so"));
  go(0.01);
  EXPECT_TRUE(says("dhdGetSDKVersion")) << message();
  arm_ = open("omega@" + library_);
  go(0.01);
  EXPECT_TRUE(says("'omega' must be the number")) << message();
  arm_ = open("7@" + library_);
  go(0.01);
  EXPECT_TRUE(says("'7' cannot be opened")) << message();
  twin_.faults.version = 9;
  arm_ = open(address_);
  go(0.01);
  EXPECT_TRUE(says("version 9.17.5")) << message();
}

TEST_F(DhdDriver, GarbageIsNeverWhereAHandIs) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    arm_.reset();
    twin_.restart(pressing_hand(), now_ns_, seed);
    twin_.faults.garbage = 0.01;  // of 12 numbers a reading
    arm_ = open(address_);
    int valid = 0;
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
