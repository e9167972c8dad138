// The driver of Haply's Inverse3: its texts, and a closed loop with its twin in the test's time.
#include "drivers/arms/inverse3.h"

#include <gtest/gtest.h>

#include <random>

#include "common/error.h"
#include "tests/haptics/press_case.h"
#include "twins/arms/inverse3_twin.h"

namespace prosector {
namespace {

TEST(Inverse3Texts, StatesAreReadAsTheServiceWritesThem) {
  const auto state = inverse3::state_of(
      R"({"inverse3":[{"device_id":"049D","config":{},"state":{"cursor_position":{"x":0.01,"y":-0.2,"z":0.1},)"
      R"("cursor_velocity":{"x":0,"y":0,"z":0}}}],"wireless_verse_grip":[{"device_id":"61548","state":)"
      R"({"orientation":{"w":0.5,"x":-0.5,"y":0.5,"z":0.5},"buttons":{"a":true,"b":false,"c":true}}}]})");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->device, "049D");
  EXPECT_EQ(state->place, Vec3(0.01, -0.2, 0.1));
  EXPECT_EQ(state->turn.coeffs(), Quat(0.5, -0.5, 0.5, 0.5).coeffs());
  EXPECT_EQ(state->buttons, 5u);
}

TEST(Inverse3Texts, WithoutAGripOrAnArmMuchIsMissingButWell) {
  const auto bare = inverse3::state_of(
      R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":1,"y":2,"z":3}}}]})");
  ASSERT_TRUE(bare);
  EXPECT_EQ(bare->turn.coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(bare->buttons, 0u);
  const auto none = inverse3::state_of(R"({"inverse3":[]})");
  ASSERT_TRUE(none);
  EXPECT_EQ(none->device, "");
}

TEST(Inverse3Texts, WhatIsNoStateIsNone) {
  for (const char* text :
       {"", "null", "[]", "{}", "42", "{\"inverse3\":", R"({"inverse3":{}})", R"({"inverse3":[{}]})",
        R"({"inverse3":[7]})",
        R"({"inverse3":[{"device_id":7,"state":{"cursor_position":{"x":1,"y":2,"z":3}}}]})",
        R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":1,"y":2}}}]})",
        R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":1,"y":2,"z":null}}}]})",
        R"({"inverse3":[{"device_id":"1","state":{"cursor_position":{"x":1,"y":2,"z":1e999}}}]})"})
    EXPECT_FALSE(inverse3::state_of(text)) << text;
}

TEST(Inverse3Texts, ForcesAreWrittenAsTheServiceReadsThem) {
  EXPECT_EQ(inverse3::text_of(inverse3::Force{"049D", Vec3(0.5, -1, 2)}),
            R"({"inverse3":[{"commands":{"set_cursor_force":{"values":{"x":0.5,"y":-1.0,"z":2.0}}},)"
            R"("device_id":"049D"}]})");
  const auto back = inverse3::force_of(inverse3::text_of(inverse3::Force{"049D", Vec3(0.5, -1, 2)}));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->device, "049D");
  EXPECT_EQ(back->force, Vec3(0.5, -1, 2));
}

/// The driver and the twin, whose texts go to and fro a thousand times a second.
class Inverse3Driver : public testing::Test {
 protected:
  std::int64_t now_ns_ = 1;
  Inverse3Twin twin_{{pressing_hand(), 1, 0}, now_ns_};
  Inverse3Arm arm_{ArmConfig{pressing_hand().room_arm}, [this] { return now_ns_; }};
  bool begun_ = false;

  void talk() {
    twin_.advance(now_ns_);
    twin_.take(arm_.handle_text(begun_ ? twin_.state() : twin_.begin()));
    begun_ = true;
  }
  ArmReading go(double seconds, const Vec3& force = Vec3::Zero()) {
    ArmReading out;
    for (int k = 0; k < static_cast<int>(1000 * seconds); ++k) {
      now_ns_ += ms;
      talk();
      out = arm_.read();
      arm_.set_force(force);
    }
    return out;
  }
  void expect_there(const ArmReading& reading) const {
    ASSERT_TRUE(reading.valid) << arm_.status().message;
    const HeldArm& held = twin_.arm();
    EXPECT_NEAR((reading.stylus.p - held.room_arm() * held.model().position()).norm(), 0, 1e-4);
    EXPECT_NEAR(reading.stylus.q.angularDistance(held.room_arm().q * held.orientation()), 0, 1e-9);
  }
};

TEST_F(Inverse3Driver, APlaneIsFeltAsStiffAsItIs) {
  for (const double stiffness : {300., 1000.}) {
    Inverse3Twin twin({pressing_hand(), 1, 0}, now_ns_);
    Inverse3Arm arm(ArmConfig{pressing_hand().room_arm}, [this] { return now_ns_; });
    twin.take(arm.handle_text(twin.begin()));
    const auto talk = [&](std::int64_t now) {
      twin.advance(now);
      twin.take(arm.handle_text(twin.state()));
    };
    expect_felt(press(arm, twin.arm(), stiffness, now_ns_, talk), stiffness);
    EXPECT_EQ(twin.bad_texts(), 0u);
  }
}

TEST_F(Inverse3Driver, ReadsPlaceTurnAndButtonsAndSetsForces) {
  twin_.buttons = 2;
  const ArmReading reading = go(1.5, {0.5, 0, 0.3});
  expect_there(reading);
  EXPECT_EQ(reading.buttons, 2u);
  EXPECT_EQ(arm_.status().health, DeviceHealth::streaming);
  const Vec3 acts = twin_.arm().room_arm().q * twin_.arm().model().force();
  EXPECT_NEAR((acts - Vec3(0.5, 0, 0.3)).norm(), 0, 1e-9);
}

TEST_F(Inverse3Driver, AServoThatHangsLeavesNoForce) {
  go(1, {1, 0, 0});
  for (int k = 0; k < 30; ++k) {
    now_ns_ += ms;
    talk();
  }
  EXPECT_EQ(twin_.arm().model().force(), Vec3::Zero());
}

TEST_F(Inverse3Driver, SilenceIsNoPose) {
  go(1);
  now_ns_ += 25 * ms;
  EXPECT_FALSE(arm_.read().valid);
}

TEST_F(Inverse3Driver, UnpluggedItIsSaidAndComesBack) {
  go(1);
  twin_.unplugged = true;
  EXPECT_FALSE(go(0.01, {1, 0, 0}).valid);
  EXPECT_EQ(arm_.status().health, DeviceHealth::absent);
  EXPECT_NE(arm_.status().message.find("no Inverse3"), std::string::npos);
  EXPECT_EQ(twin_.arm().model().force(), Vec3::Zero());
  twin_.unplugged = false;
  expect_there(go(0.01));
}

TEST_F(Inverse3Driver, GarbageIsSaidAndGetsNoForce) {
  go(1, {1, 0, 0});
  for (int k = 0; k < 10; ++k) {
    now_ns_ += ms;
    const auto answer = inverse3::force_of(arm_.handle_text("{\"inverse3\":[{\"device_id\""));
    EXPECT_FALSE(answer) << "nobody is told a force";
    EXPECT_FALSE(arm_.read().valid);
    arm_.set_force({1, 0, 0});
  }
  EXPECT_EQ(arm_.status().health, DeviceHealth::babbling);
  EXPECT_EQ(arm_.status().resyncs, 10u);
}

TEST_F(Inverse3Driver, WhateverComesAPoseIsOne) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    Inverse3Twin twin({pressing_hand(), seed, 0.3}, now_ns_);
    Inverse3Arm arm(ArmConfig{pressing_hand().room_arm}, [this] { return now_ns_; });
    twin.take(arm.handle_text(twin.begin()));
    int valid = 0;
    for (int k = 0; k < 3000; ++k) {
      now_ns_ += ms;
      twin.advance(now_ns_);
      twin.take(arm.handle_text(twin.state()));
      arm.set_force({1, 0, 0});
      const ArmReading reading = arm.read();
      if (!reading.valid) continue;
      ++valid;
      ASSERT_TRUE(reading.stylus.p.allFinite());
      ASSERT_LT((reading.stylus.p - twin.arm().room_arm().p).norm(), 2.1);
      ASSERT_NEAR(reading.stylus.q.norm(), 1, 1e-9);
    }
    EXPECT_GT(valid, 1000) << "what is good among it still counts";
  }
}

TEST(Inverse3Fuzz, ATwinBearsWhateverIsSaid) {
  std::mt19937_64 random(21);
  Inverse3Twin twin({pressing_hand(), 1, 0}, 0);
  twin.begin();
  const std::string good = inverse3::text_of(inverse3::Force{"049D", Vec3(1, 2, 3)});
  std::int64_t now = 0;
  for (int k = 0; k < 5000; ++k) {
    std::string text = good;
    for (int n = 0; n < 1 + k % 4; ++n) text[random() % text.size()] = static_cast<char>(random());
    if (k % 3 == 0) text.resize(random() % text.size());
    twin.take(text);
    twin.advance(now += ms);
    ASSERT_TRUE(twin.arm().model().position().allFinite());
    ASSERT_LT(twin.arm().model().position().norm(), 2);
  }
  EXPECT_GT(twin.bad_texts(), 1000u);
}

TEST(Inverse3Address, MustBeAHostAndAPort) {
  for (const char* path : {"localhost", ":10001", "localhost:", "localhost:port", "localhost:123456"})
    EXPECT_THROW(open_inverse3(path, {}), InputError) << path;
}

}  // namespace
}  // namespace prosector
