// The driver of an arm at a VRPN server: its bytes, and a closed loop over a net in the test's time.
#include <gtest/gtest.h>

#include <deque>
#include <random>

#include "common/error.h"
#include "drivers/arms/vrpn_arm.h"
#include "tests/haptics/press_case.h"
#include "twins/arms/vrpn_twin.h"

namespace prosector {
namespace {

using vrpn::Bytes;

TEST(VrpnBytes, AreTheProtocols) {
  const Bytes cookie = vrpn::cookie();
  ASSERT_EQ(cookie.size(), 24u);
  EXPECT_EQ(std::string(cookie.begin(), cookie.begin() + 14), "vrpn: ver. 07.");
  EXPECT_EQ(std::string(cookie.begin() + 16, cookie.begin() + 19), "  0");
  EXPECT_EQ(cookie.back(), 0);
  Bytes out;
  vrpn::put(out, vrpn::naming(vrpn::names_type, 2, "ab"));
  const Bytes expected = {0,    0,    0,    31,   0, 0, 0, 0, 0, 0, 0, 0, 0,   0,   0, 2,
                          0xff, 0xff, 0xff, 0xfe, 0, 0, 0, 0, 0, 0, 0, 3, 'a', 'b', 0, 0};
  EXPECT_EQ(out, expected);
  vrpn::ForceField field;
  field.force = {1, 0, 0};
  field.jacobian(0, 1) = -2;
  const Bytes body = vrpn::body_of(field);
  ASSERT_EQ(body.size(), 64u);
  EXPECT_EQ(Bytes(body.begin() + 12, body.begin() + 16), (Bytes{0x3f, 0x80, 0, 0})) << "1, after the origin";
  EXPECT_EQ(Bytes(body.begin() + 28, body.begin() + 32), (Bytes{0xc0, 0, 0, 0})) << "row 0, column 1";
}

TEST(VrpnBytes, ComeBackWhereverTheyAreCut) {
  Bytes stream = vrpn::cookie();
  vrpn::put(stream, vrpn::naming(vrpn::names_sender, 4, "Arm0"));
  vrpn::put(stream, vrpn::naming(vrpn::names_type, 9, vrpn::pose_type));
  const vrpn::TrackerPose pose{0, Vec3(0.1, -0.2, 0.3), Quat(0.5, -0.5, 0.5, 0.5)};
  vrpn::put(stream, {4, 9, vrpn::body_of(pose)});
  for (std::size_t cut = 0; cut <= stream.size(); ++cut) {
    vrpn::Reader reader;
    int poses = 0;
    const auto read = [&] {
      while (const auto message = reader.next()) {
        if (message->type != 9) continue;
        EXPECT_EQ(reader.sender(*message), "Arm0");
        EXPECT_EQ(reader.type(*message), vrpn::pose_type);
        const auto back = vrpn::tracker_pose_of(message->body);
        ASSERT_TRUE(back);
        EXPECT_EQ(back->place, pose.place);
        EXPECT_EQ(back->turn.coeffs(), pose.turn.coeffs());
        ++poses;
      }
    };
    reader.take(std::span(stream).first(cut));
    read();
    reader.take(std::span(stream).subspan(cut));
    read();
    EXPECT_EQ(poses, 1) << cut;
    EXPECT_FALSE(reader.broken());
  }
}

/// What the line between both does.
struct NetFaults {
  std::int64_t delay_ns = 0;  // each way
  bool away = false, cut = false, mute = false;
};

/// A line to a twin in the same process.
class NetLine final : public ByteStream {
 public:
  NetLine(VrpnTwin& twin, NetFaults& faults, const std::int64_t& now_ns)
      : twin_(twin), faults_(faults), now_ns_(now_ns) {}
  ~NetLine() override { twin_.hang_up(); }
  bool receive(Bytes& out) override {
    arrive(up_, [&](const Bytes& b) { twin_.receive(b); });
    const Bytes said = twin_.advance(now_ns_);
    if (!faults_.mute) down_.push_back({now_ns_ + faults_.delay_ns, said});
    arrive(down_, [&](const Bytes& b) { out.insert(out.end(), b.begin(), b.end()); });
    return !faults_.cut;
  }
  void send(std::span<const std::uint8_t> bytes) override {
    up_.push_back({now_ns_ + faults_.delay_ns, Bytes(bytes.begin(), bytes.end())});
  }
  const std::string& error() const override { return error_; }

 private:
  struct Sent {
    std::int64_t arrives_ns;
    Bytes bytes;
  };
  VrpnTwin& twin_;
  NetFaults& faults_;
  const std::int64_t& now_ns_;
  std::deque<Sent> up_, down_;
  std::string error_ = "the server hung up";

  template <class Take>
  void arrive(std::deque<Sent>& way, Take take) {
    for (; !way.empty() && way.front().arrives_ns <= now_ns_; way.pop_front()) take(way.front().bytes);
  }
};

class VrpnDriver : public testing::Test {
 protected:
  std::int64_t now_ns_ = 1;
  NetFaults net_;
  VrpnTwin twin_{options(1), now_ns_};
  VrpnArm arm_{"Arm0", ArmConfig{pressing_hand().room_arm}, line(twin_), std::launch::deferred,
               [this] { return now_ns_; }};

  static VrpnTwinOptions options(std::uint64_t seed, double garbage = 0) {
    return {pressing_hand(), "Arm0", seed, garbage};
  }
  std::function<std::unique_ptr<ByteStream>()> line(VrpnTwin& twin) {
    return [this, &twin]() -> std::unique_ptr<ByteStream> {
      if (net_.away) throw InputError("lab:3883: Connection refused");
      return std::make_unique<NetLine>(twin, net_, now_ns_);
    };
  }
  ArmReading go(double seconds, const Vec3& force = Vec3::Zero()) {
    ArmReading out;
    for (int k = 0; k < static_cast<int>(1000 * seconds); ++k) {
      now_ns_ += ms;
      out = arm_.read();
      arm_.set_force(force);
    }
    return out;
  }
  PressResult pressed(double stiffness, bool field) {
    VrpnTwin twin(options(1), now_ns_);
    VrpnArm arm("Arm0", ArmConfig{pressing_hand().room_arm}, line(twin), std::launch::deferred,
                [this] { return now_ns_; });
    return press(
        arm, twin.arm(), stiffness, now_ns_, [](std::int64_t) {}, field);
  }
  bool says(const std::string& words) const { return arm_.status().message.find(words) != std::string::npos; }
  void expect_there(const ArmReading& reading) const {
    ASSERT_TRUE(reading.valid) << arm_.status().message;
    const HeldArm& held = twin_.arm();
    EXPECT_NEAR((reading.stylus.p - held.room_arm() * held.model().position()).norm(), 0, 1e-4);
    EXPECT_NEAR(reading.stylus.q.angularDistance(held.room_arm().q * held.orientation()), 0, 1e-9);
  }
};

TEST_F(VrpnDriver, APlaneIsFeltAsStiffAsItIs) {
  for (const std::int64_t round_trip : {0, 2})
    for (const double stiffness : {300., 1000.}) {
      SCOPED_TRACE(round_trip);
      net_.delay_ns = round_trip * ms / 2;
      expect_felt(pressed(stiffness, true), stiffness);
    }
}

TEST_F(VrpnDriver, FarFromItsServerItIsAsStiffButBeginsLate) {
  net_.delay_ns = 10 * ms;
  for (const double stiffness : {300., 1000.}) {
    const PressResult felt = pressed(stiffness, true);
    EXPECT_NEAR(felt.force / felt.depth / stiffness, 1, 0.03);
    EXPECT_LT(felt.ripple, 3e-4);
    // The hand goes in by as much as it does in a round trip and two cycles before it is pushed back.
    const double late = hand_speed * 0.022;
    EXPECT_GT(felt.least_energy, -stiffness * late * late / 2);
    std::printf("%4.0f N/m: least energy %.3f mJ\n", stiffness, 1e3 * felt.least_energy);
  }
}

TEST_F(VrpnDriver, ForcesAloneOverTheSameNetAreUnstable) {
  net_.delay_ns = 10 * ms;
  EXPECT_GT(pressed(1000, false).ripple, 3e-4) << "the field is what holds it";
}

TEST_F(VrpnDriver, ReadsPlaceTurnAndButtonsAndSetsForces) {
  go(1.5, {0.5, 0, 0.3});
  twin_.press(true);
  const ArmReading reading = go(0.002, {0.5, 0, 0.3});
  expect_there(reading);
  EXPECT_EQ(reading.buttons, 1u);
  const Vec3 acts = twin_.arm().room_arm().q * twin_.arm().model().force();
  EXPECT_NEAR((acts - Vec3(0.5, 0, 0.3)).norm(), 0, 1e-6);
  twin_.press(false);
  EXPECT_EQ(go(0.002).buttons, 0u);
  EXPECT_EQ(twin_.bad_messages(), 0u);
}

TEST_F(VrpnDriver, MotorsThatRestAreToldAsHot) {
  go(0.1);
  twin_.queue_error_code(vrpn::duty_cycle_error);
  EXPECT_TRUE(go(0.002).hot);
  twin_.queue_error_code(vrpn::no_force_error);
  EXPECT_FALSE(go(0.002).hot);
}

TEST_F(VrpnDriver, ALineThatBreaksComesBackByItself) {
  go(1, {1, 0, 0});
  net_.cut = net_.away = true;
  EXPECT_FALSE(go(0.002, {1, 0, 0}).valid);
  EXPECT_TRUE(says("hung up")) << arm_.status().message;
  go(1);
  EXPECT_EQ(arm_.status().health, DeviceHealth::absent);
  EXPECT_TRUE(says("refused")) << arm_.status().message;
  EXPECT_EQ(twin_.arm().model().force(), Vec3::Zero());
  net_ = {};
  expect_there(go(1));
  EXPECT_EQ(arm_.status().reopens, 1u);
}

TEST_F(VrpnDriver, SilenceIsNoPoseAndTriedAnew) {
  go(1);
  net_.mute = true;
  EXPECT_FALSE(go(0.2).valid);
  EXPECT_EQ(arm_.status().health, DeviceHealth::silent);
  go(3);
  EXPECT_TRUE(says("no longer sends data")) << arm_.status().message;
  net_.mute = false;
  expect_there(go(1));
}

TEST_F(VrpnDriver, WhoseNameIsAnotherIsNotIt) {
  VrpnArm other("Arm1", {}, line(twin_), std::launch::deferred, [this] { return now_ns_; });
  for (int k = 0; k < 200; ++k) {
    now_ns_ += ms;
    EXPECT_FALSE(other.read().valid);
  }
  EXPECT_NE(other.status().message.find("'Arm1'"), std::string::npos);
}

TEST_F(VrpnDriver, WhateverComesAPoseIsOne) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    VrpnTwin twin(options(seed, 0.3), now_ns_);
    VrpnArm arm("Arm0", ArmConfig{pressing_hand().room_arm}, line(twin), std::launch::deferred,
                [this] { return now_ns_; });
    int valid = 0;
    for (int k = 0; k < 3000; ++k) {
      now_ns_ += ms;
      const ArmReading reading = arm.read();
      arm.set_force({1, 0, 0});
      if (!reading.valid) continue;
      ++valid;
      ASSERT_TRUE(reading.stylus.p.allFinite());
      ASSERT_LT((reading.stylus.p - twin.arm().room_arm().p).norm(), 2.1);
      ASSERT_NEAR(reading.stylus.q.norm(), 1, 1e-9);
    }
    EXPECT_GT(valid, 1000) << "what is good among it still counts";
    EXPECT_EQ(arm.status().reopens, 0u) << "its messages are whole";
  }
}

TEST(VrpnFuzz, NeitherSideFallsOverWhatever) {
  std::mt19937_64 random(31);
  for (int k = 0; k < 2000; ++k) {
    Bytes stream = vrpn::cookie();
    vrpn::put(stream, vrpn::naming(vrpn::names_sender, 0, "Arm0"));
    vrpn::put(stream, vrpn::naming(vrpn::names_type, 0, vrpn::field_type));
    vrpn::put(stream, {0, 0, vrpn::body_of(vrpn::ForceField{Vec3::Zero(), Vec3(1, 2, 3), Mat3::Zero(), 1})});
    for (int n = 0; n < 1 + k % 6; ++n)
      stream[random() % stream.size()] = static_cast<std::uint8_t>(random());
    if (k % 3 == 0) stream.resize(random() % stream.size());
    VrpnTwin twin({pressing_hand(), "Arm0", 1, 0}, 0);
    twin.receive(stream);
    for (std::int64_t now = ms; now < 20 * ms; now += ms) twin.advance(now);
    ASSERT_TRUE(twin.arm().model().position().allFinite()) << k;
    vrpn::Reader reader;
    reader.take(stream);
    for (int n = 0; reader.next(); ++n) ASSERT_LT(n, 100) << k;
  }
}

TEST(VrpnAddress, NamesADeviceAndAHost) {
  for (const char* path :
       {"Phantom0", "@lab", "Phantom0@", "Phantom0@lab:", "Phantom0@lab:port", "Phantom0@:3883"})
    EXPECT_THROW(open_vrpn(path, {}), InputError) << path;
}

}  // namespace
}  // namespace prosector
