// The Omni's bytes and geometry, and its driver at a twin's socket.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "drivers/omni.h"
#include "drivers/omni_arm_math.h"
#include "drivers/twins/omni_twin.h"

namespace prosector {
namespace {

TEST(OmniGeometry, JointsAndPlacesFitEachOther) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> x(-0.08, 0.08), y(-0.06, 0.06), z(-0.035, 0.035);
  for (int k = 0; k < 1000; ++k) {
    const Vec3 place(x(random), y(random), z(random));
    const auto joints = omni::joints_at(place);
    ASSERT_TRUE(joints);
    EXPECT_NEAR((omni::tip(*joints) - place).norm(), 0, 1e-12);
  }
  EXPECT_FALSE(omni::joints_at({1, 0, 0}));
}

TEST(OmniGeometry, JacobianIsTheDerivative) {
  const omni::Joints joints(0.2, 0.5, -0.1);
  const Mat3 jacobian = omni::jacobian(joints);
  for (int i = 0; i < 3; ++i) {
    omni::Joints more = joints, less = joints;
    more[i] += 1e-6;
    less[i] -= 1e-6;
    EXPECT_NEAR(((omni::tip(more) - omni::tip(less)) / 2e-6 - jacobian.col(i)).norm(), 0, 1e-9);
  }
}

TEST(OmniGeometry, CommandsMakeTheForceAskedForAndKeepItsDirection) {
  const auto joints = omni::joints_at({0.01, 0.02, -0.01});
  const Vec3 small(0.5, -0.7, 0.3), large = 100 * small;
  EXPECT_NEAR((omni::force_of(*joints, omni::commands_for(*joints, small)) - small).norm(), 0, 1e-9);
  const Vec3 most = omni::force_of(*joints, omni::commands_for(*joints, large));
  EXPECT_NEAR(most.normalized().dot(small.normalized()), 1, 1e-12);
  EXPECT_LE(omni::commands_for(*joints, large).cwiseAbs().maxCoeff(), 1);
}

TEST(OmniGeometry, ACountIsAboutFiveHundredthsOfAMillimetre) {
  const omni::Joints joints = omni::docked;
  auto counts = omni::counts_of(joints);
  const Vec3 before = omni::tip(omni::joints_of(counts));
  ++counts[0];
  EXPECT_NEAR((omni::tip(omni::joints_of(counts)) - before).norm(), 5.5e-5, 2.5e-5);
}

TEST(OmniGeometry, ItsInkwellIsWhereItIsKnownToBe) {
  // Public drivers tell about (0, −65, −88) mm.
  EXPECT_NEAR((omni::tip(omni::docked) - Vec3(0, -0.0655, -0.0881)).norm(), 0, 0.006);
}

TEST(OmniPackets, AreWhatPublicDriversSend) {
  omni::Command off;
  const auto bytes = omni::bytes_of(off);
  const std::array<std::uint8_t, 16> expected = {0xff, 0x07, 0xff, 0x07, 0xff, 0x07, 0xc0, 0x53};
  EXPECT_EQ(bytes, expected);
  omni::Command full;
  full.motors = {1, -1, 0};
  full.motors_on = true;
  const auto driven = omni::bytes_of(full);
  EXPECT_EQ(driven[0] | driven[1] << 8, 4095);
  EXPECT_EQ(driven[2] | driven[3] << 8, 0);
  EXPECT_EQ(driven[6] | driven[7] << 8, 0x53c8);
}

TEST(OmniPackets, ComeBackAsTheyWere) {
  omni::State state;
  state.encoders = {-3, 12000, -32768};
  state.number = 200;
  state.buttons = 2;
  state.docked = true;
  state.count = 0x12345678;
  omni::set_gimbal(state, {0.3, -0.4, 0.1});
  const auto back = omni::state_of(omni::bytes_of(state));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->encoders, state.encoders);
  EXPECT_EQ(back->number, state.number);
  EXPECT_EQ(back->buttons, state.buttons);
  EXPECT_EQ(back->docked, state.docked);
  EXPECT_EQ(back->count, state.count);
  EXPECT_NEAR((omni::gimbal_of(*back) - Vec3(0.3, -0.4, 0.1)).norm(), 0, 0.01);
  omni::Command command;
  command.motors = {0.25, -0.5, 0.75};
  command.motors_on = true;
  command.light = 2;
  const auto said = omni::command_of(omni::bytes_of(command));
  ASSERT_TRUE(said);
  EXPECT_NEAR((said->motors - command.motors).norm(), 0, 1e-3);
  EXPECT_EQ(said->light, 2);
}

/// A line to a twin in the same process, in the test's own time.
class TwinLine final : public omni::Line {
 public:
  struct Faults {
    bool away = false;  // it can't be opened
    bool mute = false;  // no packets come
    std::uint32_t kind = omni::kind;
  };
  TwinLine(OmniTwin& twin, Faults& faults, std::int64_t& now_ns)
      : twin_(twin), faults_(faults), now_ns_(now_ns) {}
  bool open() override { return open_ = !faults_.away; }
  void close() override {
    open_ = false;
    const std::uint8_t off = 0;
    twin_.write(omni::control_register, {&off, 1}, now_ns_);
  }
  bool is_open() const override { return open_; }
  const std::string& error() const override { return error_; }
  std::optional<std::uint32_t> read(std::uint64_t address) override {
    return address == omni::kind_register ? faults_.kind : twin_.read(address);
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) override {
    twin_.write(address, bytes, now_ns_);
    return true;
  }
  bool start(std::uint8_t, std::uint8_t) override { return true; }
  std::optional<std::array<std::uint8_t, omni::state_bytes>> receive() override {
    if (faults_.mute || fresh_ == now_ns_) return std::nullopt;
    fresh_ = now_ns_;
    return twin_.advance(now_ns_);
  }
  bool send(std::span<const std::uint8_t, omni::command_bytes> packet) override {
    twin_.command(packet);
    return true;
  }

 private:
  OmniTwin& twin_;
  Faults& faults_;
  std::int64_t& now_ns_;
  std::int64_t fresh_ = -1;
  bool open_ = false;
  std::string error_ = "away";
};

/// A driver and a twin whose hand holds still at a place.
class OmniDriver : public testing::Test {
 protected:
  static constexpr double held = 0.1 / 200 + 1e-4;  // m: by friction against the hand, and a count
  const Vec3 place_{0.02, 0.01, 0.0};
  std::int64_t now_ns_ = 1;
  TwinLine::Faults faults_;
  OmniTwin twin_{options(), now_ns_};
  OmniArm arm_{std::make_unique<TwinLine>(twin_, faults_, now_ns_), ArmConfig{}, [this] { return now_ns_; }};

  OmniTwinOptions options() const {
    OmniTwinOptions out;
    out.script.add(0, 0, Pose{place_, Quat::Identity()});
    return out;
  }
  ArmReading go(double seconds, const Vec3& force = Vec3::Zero()) {
    ArmReading out;
    for (int k = 0; k < static_cast<int>(1000 * seconds); ++k) {
      now_ns_ += 1'000'000;
      out = arm_.read();
      arm_.set_force(force);
    }
    return out;
  }
};

TEST_F(OmniDriver, IsValidOnceItWasDockedAndIsTaken) {
  EXPECT_FALSE(go(0.1).valid) << "still in its inkwell";
  const ArmReading reading = go(1.5);
  EXPECT_TRUE(reading.valid);
  EXPECT_NEAR((reading.stylus.p - place_).norm(), 0, held) << "wherever its encoders began";
}

TEST_F(OmniDriver, ForceGoesWhereItIsSent) {
  const Vec3 before = go(1.5).stylus.p;
  const Vec3 after = go(1, {0.5, 0, 0.3}).stylus.p;
  const Vec3 moved = after - before;  // against 200 N/m
  EXPECT_NEAR(moved.x(), 0.5 / 200, held);
  EXPECT_NEAR(moved.z(), 0.3 / 200, held);
  EXPECT_EQ(twin_.bad_commands(), 0u);
}

TEST_F(OmniDriver, SaysWhatIsMissing) {
  faults_.away = true;
  EXPECT_FALSE(go(0.1).valid);
  EXPECT_EQ(arm_.status().health, DeviceHealth::absent);
  faults_.away = false;
  faults_.kind = 7;
  go(1);
  EXPECT_EQ(arm_.status().health, DeviceHealth::absent);
  EXPECT_NE(arm_.status().message.find("no Omni"), std::string::npos);
  faults_.kind = omni::kind;
  EXPECT_TRUE(go(2).valid);
  faults_.mute = true;
  EXPECT_FALSE(go(0.1).valid) << "without packets nothing is known";
  EXPECT_EQ(go(1, {1, 0, 0}).valid, false);
  EXPECT_EQ(twin_.model().force(), Vec3::Zero()) << "its motors are off";
  faults_.mute = false;
  EXPECT_TRUE(go(3).valid) << "it comes back by itself";
}

TEST(OmniSocket, NobodyThereIsNoError) {
  const auto arm = open_omni_twin("/nonexistent/omni", {});
  EXPECT_FALSE(arm->read().valid);
  arm->set_force({1, 0, 0});
  EXPECT_EQ(arm->status().health, DeviceHealth::absent);
  EXPECT_NE(arm->status().message.find("/nonexistent/omni"), std::string::npos);
}

}  // namespace
}  // namespace prosector
