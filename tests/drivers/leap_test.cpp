// Hands of Ultraleap's texts: poses and bends of the project's own hand come back, spoilt texts make none.
#include <gtest/gtest.h>

#include <random>

#include "drivers/trackers/leap_device.h"
#include "tests/gesture_bends.h"
#include "twins/trackers/leap_twin.h"

namespace prosector {
namespace {

const Pose camera_stand{{0.1, 0.9, 0.2}, Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY()))};

leap::Text random_frame(std::mt19937& random) {
  std::uniform_real_distribution<double> some(-1, 1), bent(0, 1);
  leap::Text out;
  for (const bool left : {false, true}) {
    const Pose wrist{Vec3(0.3 * some(random), 0.3 + 0.2 * some(random), 0.3 * some(random)),
                     Quat(some(random), some(random), some(random), 1.1 + some(random)).normalized()};
    std::array<double, fingers> flexion{};
    for (double& f : flexion) f = bent(random);
    out.hands.push_back(simulated_hand(left, wrist, flexion));
  }
  return out;
}

TEST(Leap, PosesAndBendsOfTheOwnHandComeBack) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> some(-1, 1), bent(0, 1);
  for (int k = 0; k < 200; ++k)
    for (const bool left : {false, true}) {
      const Pose wrist{Vec3(some(random), some(random), some(random)),
                       Quat(some(random), some(random), some(random), 1.1 + some(random)).normalized()};
      std::array<double, fingers> flexion{};
      for (double& f : flexion) f = bent(random);
      leap::Text frame;
      frame.hands.push_back(simulated_hand(left, wrist, flexion));
      const auto back = leap::read_text(leap::text_of(frame, k));
      ASSERT_TRUE(back);
      ASSERT_EQ(back->hands.size(), 1u);
      EXPECT_EQ(back->hands[0].left, left);
      const Pose pose = leap::wrist_of(back->hands[0]);
      EXPECT_LT((pose.p - wrist.p).norm(), 1e-9);
      EXPECT_NEAR(std::abs(pose.q.dot(wrist.q)), 1, 1e-9);
      const auto bends = leap::flexion_of(back->hands[0]);
      for (std::size_t f = 0; f < fingers; ++f) EXPECT_NEAR(bends[f], flexion[f], 1e-6) << f;
    }
}

TEST(Leap, TellsEachGestureOfTheTable) {
  GestureThresholds thresholds;
  thresholds.pinch = true;
  LeapDevice device("here", {}, thresholds);
  leap::Text greeting;
  greeting.version = leap::known_version;
  device.handle_text(leap::text_of(greeting, 0));
  const Pose wrist{{0.1, 0.2, 0}, Quat::Identity()};
  int number = 0;
  for_gestures([&](const GestureRow& row) {
    leap::Text frame;
    frame.hands = {simulated_hand(false, wrist, bends_of(row)), simulated_hand(true, wrist, bends_of(row))};
    device.handle_text(leap::text_of(frame, ++number));
    std::vector<DeviceSample> samples;
    device.poll(samples);
    ASSERT_EQ(samples.size(), 2u);
    for (const DeviceSample& sample : samples) EXPECT_EQ(sample.gesture, row.gesture) << row.name;
  });
}

TEST(Leap, BothHandsReachTheRoomWithTheirGestures) {
  Placement placement;
  placement.room_device = camera_stand;
  LeapDevice device("here", placement, {});
  leap::Text greeting;
  greeting.version = leap::known_version;
  EXPECT_EQ(device.handle_text(leap::text_of(greeting, 0)),
            (std::vector<std::string>{R"({"background":true})", R"({"focused":true})"}));
  const Pose right{{0.1, 0.2, 0}, Quat::Identity()}, left{{-0.1, 0.2, 0}, Quat::Identity()};
  leap::Text frame;
  frame.hands = {simulated_hand(false, right, {1, 1, 1, 1, 1}), simulated_hand(true, left, {0, 0, 0, 0, 0})};
  EXPECT_EQ(device.handle_text(leap::text_of(frame, 1)), std::vector<std::string>{});
  std::vector<DeviceSample> samples;
  device.poll(samples);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].station, 0u);
  EXPECT_LT((samples[0].pose.p - camera_stand * right.p).norm(), 1e-9);
  EXPECT_EQ(samples[0].gesture, Gesture::fist);
  EXPECT_EQ(samples[1].station, 1u);
  EXPECT_EQ(samples[1].gesture, Gesture::flat);
  greeting.version = leap::known_version + 1;
  device.handle_text(leap::text_of(greeting, 2));
  device.handle_text(leap::text_of(frame, 3));
  samples.clear();
  device.poll(samples);
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(device.status().health, DeviceHealth::babbling);
  EXPECT_NE(device.status().message.find("version 7"), std::string::npos);
}

TEST(Leap, EventsAreNoGarbage) {
  LeapDevice device("here", {}, {});
  for (const char* text :
       {R"({"event":{"state":{"attached":true,"id":"1","streaming":true,"type":"x"},"type":"deviceEvent"}})",
        R"({"event":{"type":"deviceEvent","state":{"attached":false,"streaming":false}}})",
        R"({"event":{"type":"somethingNew"}})"}) {
    EXPECT_EQ(device.handle_text(text), std::vector<std::string>{}) << text;
    std::vector<DeviceSample> samples;
    device.poll(samples);
    EXPECT_TRUE(samples.empty());
  }
  EXPECT_EQ(device.status().resyncs, 0u);
  EXPECT_EQ(device.status().records, 0u) << "no frame came";
  const auto gone = leap::read_text(R"({"event":{"type":"deviceEvent","state":{"streaming":false}}})");
  ASSERT_TRUE(gone && gone->streaming);
  EXPECT_FALSE(*gone->streaming);
  EXPECT_FALSE(leap::read_text(R"({"event":7})"));
}

TEST(Leap, AFingerWithoutBonesIsNone) {
  leap::Text frame;
  frame.hands.push_back(simulated_hand(false, {{0.1, 0.2, 0}, Quat::Identity()}, {}));
  EXPECT_TRUE(leap::read_text(leap::text_of(frame, 0)));
  frame.hands[0].joints[2].fill(Vec3(0.1, 0.2, 0));
  EXPECT_FALSE(leap::read_text(leap::text_of(frame, 0)));
}

TEST(Leap, SpoiltTextsMakeNoImplausibleHands) {
  std::mt19937 random(5);
  LeapDevice device("here", {}, {});
  std::uint64_t read = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = leap::text_of(random_frame(random), round);
    for (auto k = 1 + random() % 3; k > 0; --k) {
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.insert(at, 1, "0123456789.-e[]{},\""[random() % 19]);
          break;
        case 2:
          text.erase(at, 1 + random() % 5);
          break;
        default:
          text.resize(std::max<std::size_t>(at, 1));
      }
    }
    device.handle_text(text);
    std::vector<DeviceSample> samples;
    device.poll(samples);
    read += samples.size();
    for (const DeviceSample& s : samples) {
      ASSERT_LT(s.station, 2u);
      ASSERT_TRUE(s.pose.p.allFinite() && s.pose.p.norm() < 5);
      ASSERT_NEAR(s.pose.q.norm(), 1, 1e-6);
      for (const double f : s.flexion) ASSERT_TRUE(f >= 0 && f <= 1);
    }
  }
  EXPECT_GT(read, 100u) << "not all that is spoilt is unreadable";
  EXPECT_GT(device.status().resyncs, 1000u);
}

}  // namespace
}  // namespace prosector
