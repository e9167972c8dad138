// The Omni's bytes and geometry, and its driver at a twin's socket.
#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "common/commands.h"
#include "drivers/arms/omni.h"
#include "drivers/arms/omni_arm_math.h"
#include "tests/haptics/press_case.h"
#include "twins/arms/omni_twin.h"

namespace prosector {
namespace {

/// Poses of a stylus as a public driver computes them from encoder counts since the dock: it takes the second
/// joint's angle off the third encoder's, and its robot description adds it again along the chain. Its frame
/// is x away from the user, y left, z up; here it is turned into an arm's frame.
struct PublicDriver {
  static constexpr double angle = 2 * std::numbers::pi / 15000, link = 0.13335;
  double waist, shoulder, elbow;

  explicit PublicDriver(const std::array<int, 3>& counts)
      : waist(angle * counts[0]),
        shoulder(angle * -counts[1] + 0.23),
        elbow(angle * counts[2] - 0.37 - shoulder) {}

  Vec3 place() const {
    const double lower_bar = shoulder + elbow;
    const double out = link * (std::cos(shoulder) + std::sin(lower_bar));
    const double up = link * (std::sin(shoulder) - std::cos(lower_bar));
    return {std::sin(waist) * out, up + 0.02335, std::cos(waist) * out - 0.16835};
  }
  Mat3 turn(const Vec3& wrist) const {
    const auto about = [](double a, const Vec3& axis) {
      return Eigen::AngleAxisd(a, axis).toRotationMatrix();
    };
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Mat3 chain = about(waist, z) * about(shoulder, y) * about(elbow, y) * about(wrist[0], z) *
                       about(wrist[1], y) * about(wrist[2], x);
    const Mat3 to_arm = (Mat3() << 0, -1, 0, 0, 0, 1, -1, 0, 0).finished();
    return to_arm * chain * to_arm.transpose();
  }
};

/// Calls `check` with random encoder counts over the whole range of the joints, and random wrist angles.
template <class Check>
void over_joint_range(const Check& check) {
  std::mt19937_64 random(3);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int k = 0; k < 2000; ++k) {
    const Vec3 joints(within(-0.98, 0.98), within(0, 1.75), within(-0.81, 1.25));
    const Vec3 counts = (joints - Vec3(0, 0.23, -0.37)) / PublicDriver::angle;
    check({static_cast<int>(counts[0]), static_cast<int>(-counts[1]), static_cast<int>(counts[2])},
          Vec3(within(-2.7, 2.7), within(-1.5, 1.5), within(-2.3, 2.3)), random);
  }
}

TEST(OmniGeometry, PosesAreThoseOfPublicDriversOverTheWholeRange) {
  over_joint_range([](const std::array<int, 3>& counts, const Vec3& wrist, auto&) {
    const PublicDriver expected(counts);
    const omni::Joints joints = omni::joints_of(counts);
    ASSERT_NEAR((omni::tip(joints) - expected.place()).norm(), 0, 1e-12);
    ASSERT_NEAR((omni::orientation(joints, wrist).toRotationMatrix() - expected.turn(wrist)).norm(), 0,
                1e-12);
  });
}

TEST(OmniGeometry, MotorsDoTheWorkOfTheForceOverTheWholeRange) {
  over_joint_range([](const std::array<int, 3>& counts, const Vec3&, std::mt19937_64& random) {
    std::uniform_real_distribution<double> newton(-0.3, 0.3);
    const Vec3 force(newton(random), newton(random), newton(random));
    const Vec3 torque = omni::full_command_torque * omni::commands_for(omni::joints_of(counts), force);
    for (std::size_t i = 0; i < 3; ++i) {  // each motor turns what its own encoder counts
      std::array<int, 3> more = counts, less = counts;
      ++more[i];
      --less[i];
      const Vec3 way = PublicDriver(more).place() - PublicDriver(less).place();
      const double turn = (i == 1 ? -2 : 2) * PublicDriver::angle;
      ASSERT_NEAR(force.dot(way), torque[static_cast<Eigen::Index>(i)] * turn, 1e-10);
    }
  });
}

TEST(OmniGeometry, TheTwinIsBuiltLikePublicDrivers) {
  over_joint_range([](const std::array<int, 3>& counts, const Vec3& wrist, std::mt19937_64& random) {
    const PublicDriver expected(counts);
    omni_body::Chain chain{expected.waist, expected.shoulder, expected.elbow, wrist};
    ASSERT_EQ(omni_body::encoders_of(chain, {}), counts);
    const Pose pose = omni_body::stylus_of(chain);
    ASSERT_NEAR((pose.p - expected.place()).norm(), 0, 1e-12);
    ASSERT_NEAR((pose.q.toRotationMatrix() - expected.turn(wrist)).norm(), 0, 1e-12);
    if (std::abs(chain.elbow) > 1.5) return;  // nearly stretched or folded
    const auto back = omni_body::chain_at(pose);
    ASSERT_TRUE(back);
    ASSERT_NEAR((omni_body::stylus_of(*back).p - pose.p).norm(), 0, 1e-9);
    ASSERT_NEAR(omni_body::stylus_of(*back).q.angularDistance(pose.q), 0, 1e-6);
    std::uniform_real_distribution<double> newton(-0.3, 0.3);
    const Vec3 force(newton(random), newton(random), newton(random));
    const Vec3 made = omni_body::force_of(chain, omni::commands_for(omni::joints_of(counts), force));
    ASSERT_NEAR((made - force).norm(), 0, 1e-6);
  });
  EXPECT_FALSE(omni_body::chain_at({Vec3(1, 0, 0), Quat::Identity()}));
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

TEST(OmniGeometry, CommandsKeepTheForcesDirection) {
  const omni::Joints joints(0.2, 0.5, -0.1);
  const Vec3 small(0.5, -0.7, 0.3), large = 100 * small;
  const Vec3 most = omni::commands_for(joints, large), little = omni::commands_for(joints, small);
  EXPECT_LE(most.cwiseAbs().maxCoeff(), 1);
  EXPECT_NEAR(most.normalized().dot(little.normalized()), 1, 1e-12);
}

TEST(OmniGeometry, ACountIsAboutFiveHundredthsOfAMillimetre) {
  const Vec3 before = omni::tip(omni::joints_of({0, 0, 0}));
  EXPECT_NEAR((omni::tip(omni::joints_of({1, 0, 0})) - before).norm(), 5.5e-5, 2.5e-5);
}

TEST(OmniGeometry, ItsInkwellIsWhereItIsKnownToBe) {
  // Public drivers tell about (0, −65, −88) mm.
  EXPECT_NEAR((omni::tip(omni::docked) - Vec3(0, -0.0655, -0.0881)).norm(), 0, 0.006);
}

TEST(OmniRegisters, AreReadInTheBusOrder) {
  // Public drivers read 0x000b9900 after turning the bus' order into their own: the maker's number first.
  EXPECT_EQ(omni::number_of({0x00, 0x0b, 0x99, 0x00}), omni::kind);
  EXPECT_NE(omni::number_of({0x00, 0x99, 0x0b, 0x00}), omni::kind);
  EXPECT_EQ(omni::kind_register, 0x1006000cu);
  EXPECT_EQ(omni_body::register_bytes(0x1006000c), (omni::Word{0x00, 0x0b, 0x99, 0x00}));
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

TEST(OmniPackets, StatesAreReadAsTheTwinWritesThem) {
  const Vec3 wrist(0.3, -0.4, 0.1);
  const auto state = omni::state_of(omni_body::state_packet({-3, 12000, -32768}, wrist, true, 0x12345678));
  ASSERT_TRUE(state);
  EXPECT_EQ(state->encoders, (std::array<std::int16_t, 3>{-3, 12000, -32768}));
  EXPECT_EQ(state->number, 0x78);
  EXPECT_EQ(state->buttons, 0u);
  EXPECT_TRUE(state->docked);
  EXPECT_EQ(state->count, 0x12345678u);
  EXPECT_NEAR((omni::gimbal_of(*state) - wrist).norm(), 0, 0.01);
}

TEST(OmniPackets, PotsWithoutVoltageAreNoPose) {
  auto packet = omni_body::state_packet({0, 0, 0}, Vec3::Zero(), false, 0);
  for (const std::size_t at : {12u, 13u, 24u, 25u}) packet[at] = 0;  // the second pot's two ends
  EXPECT_FALSE(omni::state_of(packet));
}

TEST(OmniPackets, CommandsAreReadByTheTwin) {
  omni::Command command;
  command.motors = {0.25, -0.5, 0.75};
  command.motors_on = true;
  command.light = 2;
  const auto motors = omni_body::motors_of(omni::bytes_of(command));
  ASSERT_TRUE(motors);
  EXPECT_TRUE(motors->on);
  EXPECT_NEAR((motors->shares - command.motors).norm(), 0, 1e-3);
}

/// A line to a twin in the same process, in the test's own time.
class TwinLine final : public omni::Line {
 public:
  struct Faults {
    bool away = false;  // it can't be opened
    bool mute = false;  // no packets come
    omni::Word kind = omni_body::register_bytes(omni_body::vendor_register);
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
  std::optional<omni::Word> read(std::uint64_t address) override {
    return address == omni_body::vendor_register ? faults_.kind : twin_.read(address);
  }
  bool write(std::uint64_t address, std::span<const std::uint8_t> bytes) override {
    twin_.write(address, bytes, now_ns_);
    return true;
  }
  std::optional<omni::Channels> start() override { return omni::Channels{}; }
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
  const Quat turn_ = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 2, -1).normalized()));
  std::int64_t now_ns_ = 1;
  TwinLine::Faults faults_;
  OmniTwin twin_{options(), now_ns_};
  OmniArm arm_{std::make_unique<TwinLine>(twin_, faults_, now_ns_), ArmConfig{}, [this] { return now_ns_; }};

  OmniTwinOptions options() const {
    OmniTwinOptions out;
    out.script.add(0, 0, Pose{place_, turn_});
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
  EXPECT_NEAR(reading.stylus.q.angularDistance(turn_), 0, 0.02) << "as exact as its pots";
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
  faults_.kind = {0x00, 0x99, 0x0b, 0x00};
  go(1);
  EXPECT_EQ(arm_.status().health, DeviceHealth::absent);
  EXPECT_NE(arm_.status().message.find("not an Omni"), std::string::npos);
  faults_.kind = omni_body::register_bytes(omni_body::vendor_register);
  EXPECT_TRUE(go(2).valid);
  faults_.mute = true;
  EXPECT_FALSE(go(0.1).valid) << "without packets nothing is known";
  EXPECT_EQ(go(1, {1, 0, 0}).valid, false);
  EXPECT_EQ(twin_.model().force(), Vec3::Zero()) << "its motors are off";
  faults_.mute = false;
  EXPECT_TRUE(go(3).valid) << "it comes back by itself";
}

TEST(OmniPress, APlaneIsFeltAsStiffAsItIs) {
  for (const double stiffness : {300., 700.}) {
    std::int64_t now_ns = 1;
    TwinLine::Faults none;
    OmniTwinOptions options;
    static_cast<HeldArmOptions&>(options) = pressing_hand();
    options.room_arm.p.y() += 0.09;  // so that the inkwell is above the plane
    OmniTwin twin(options, now_ns);
    OmniArm arm(std::make_unique<TwinLine>(twin, none, now_ns), ArmConfig{options.room_arm},
                [&] { return now_ns; });
    expect_felt(press(arm, twin.arm(), stiffness, now_ns, [](std::int64_t) {}), stiffness);
  }
}

TEST(OmniSocket, ALineThatIsNotOpenSaysWhyItDoesNotStart) {
  const auto line = omni::make_socket_line("/nonexistent/omni");
  EXPECT_FALSE(line->start());
  EXPECT_NE(line->error().find("/nonexistent/omni: the connection"), std::string::npos) << line->error();
  EXPECT_FALSE(line->open());
  const std::string why = line->error();
  EXPECT_FALSE(line->start());
  EXPECT_EQ(line->error(), why) << "the reason of the failed connection remains";
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
