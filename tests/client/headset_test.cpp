// What a headset says of eyes and hands, as cameras and hands of ours.

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "client/app/user/device_rig.h"
#include "client/render/projection.h"
#include "client/view/headset_text.h"
#include "client/xr/eye_view.h"
#include "client/xr/hand_joints.h"
#include "common/hand.h"
#include "drivers/device/gesture.h"
#include "tests/gesture_bends.h"
#include "twins/trackers/simulated_wearer.h"

namespace prosector {
namespace {

const Pose somewhere{{0.3, 1.2, -0.4}, Quat(0.8, 0.3, -0.5, 0.1).normalized()};

HeadsetJoints joints_at(const Pose& wrist, std::size_t hand, const std::array<double, fingers>& flexion) {
  HeadsetJoints out = hand_model_joints(hand, flexion);
  for (Pose& joint : out) joint = wrist * joint;
  return out;
}

void expect_same(const Pose& a, const Pose& b) {
  EXPECT_LT((a.p - b.p).norm(), 1e-9);
  EXPECT_LT(a.q.angularDistance(b.q), 1e-7);
}

TEST(HeadsetHand, FlatFistAndEachFingerComeBack) {
  std::vector<std::array<double, fingers>> hands = {
      {0, 0, 0, 0, 0}, {1, 1, 1, 1, 1}, {0.5, 0.4, 0.3, 0.2, 0.1}};
  for (std::size_t finger = 0; finger < fingers; ++finger) {
    hands.push_back({0, 0, 0, 0, 0});
    hands.back()[finger] = 0.8;
  }
  for (std::size_t hand : {left_hand, right_hand})
    for (const auto& flexion : hands) {
      const auto seen = hand_of_joints(joints_at(somewhere, hand, flexion));
      ASSERT_TRUE(seen);
      expect_same(seen->wrist, somewhere);
      for (std::size_t finger = 0; finger < fingers; ++finger)
        EXPECT_NEAR(seen->flexion[finger], flexion[finger], 1e-9) << "hand " << hand << ", finger " << finger;
    }
}

// UserAvatars's fingers don't bend by our law: then the three joints are weighed.
TEST(HeadsetHand, FitsFingersThatBendOtherwise) {
  HeadsetJoints joints = joints_at({}, right_hand, {0, 0, 0, 0, 0});
  const Quat bend(Eigen::AngleAxisd(-0.6, Vec3::UnitX()));  // of the index finger's middle joint alone
  for (std::size_t joint = 8; joint <= 10; ++joint) joints[joint].q = joints[joint].q * bend;
  const auto seen = hand_of_joints(joints);
  ASSERT_TRUE(seen);
  EXPECT_NEAR(seen->flexion[1], 0.6 / (std::numbers::pi / 2 * (1 + 1 + 4.0 / 9)), 1e-9);
  EXPECT_NEAR(seen->flexion[2], 0, 1e-9);
}

TEST(HeadsetHand, SpreadFingersAndAThumbAsideAreNoBend) {
  HeadsetJoints joints = joints_at(somewhere, left_hand, {0, 0, 0, 0, 0});
  const Quat aside(Eigen::AngleAxisd(0.3, Vec3::UnitY()));
  for (std::size_t first : {std::size_t{3}, std::size_t{7}, std::size_t{22}})
    for (std::size_t joint = first; joint < first + 3; ++joint) joints[joint].q = joints[joint].q * aside;
  const auto seen = hand_of_joints(joints);
  ASSERT_TRUE(seen);
  for (const double flexion : seen->flexion) EXPECT_NEAR(flexion, 0, 1e-9);
}

TEST(HeadsetHand, GarbageIsNoHand) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    HeadsetJoints joints = joints_at(somewhere, right_hand, {0, 0, 0, 0, 0});
    const float bad =
        round % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : std::numeric_limits<float>::infinity();
    Pose& joint = joints[random() % headset_joints];
    (round % 3 == 0 ? joint.p.x() : joint.q.w()) = bad;
    EXPECT_FALSE(hand_of_joints(joints));
  }
  EXPECT_FALSE(hand_of_controller(right_hand, {somewhere, std::numeric_limits<double>::quiet_NaN(), 0}));
}

TEST(HeadsetHand, MakesEachGestureOfTheTable) {
  GestureThresholds thresholds;
  thresholds.pinch = true;
  for (const std::size_t hand : {left_hand, right_hand}) {
    GestureDetector gestures(thresholds);
    for_gestures([&](const GestureRow& row) {
      const auto seen = hand_of_joints(joints_at(somewhere, hand, bends_of(row)));
      ASSERT_TRUE(seen);
      EXPECT_EQ(gestures.update(seen->flexion), row.gesture) << row.name;
    });
  }
}

TEST(HeadsetController, TriggerGraspsAndSqueezePoints) {
  MotionScript script;
  for (std::size_t hand : {left_hand, right_hand}) script.add(1 + hand, 0, somewhere);
  const SimulatedWearer wearer(script);
  for (std::size_t hand : {left_hand, right_hand}) {
    GestureDetector gestures({.closed_above = 0.65, .open_below = 0.35, .hysteresis = 0.05});
    const Pose grip = wearer.grip(hand, 0);
    const struct {
      double trigger, squeeze;
      Gesture gesture;
    } rows[] = {{0, 0, Gesture::flat}, {1, 0, Gesture::fist}, {0, 1, Gesture::point}, {1, 1, Gesture::fist}};
    for (const auto& row : rows) {
      const auto seen = hand_of_controller(hand, {grip, row.trigger, row.squeeze});
      ASSERT_TRUE(seen);
      expect_same(seen->wrist, somewhere);
      EXPECT_EQ(gestures.update(seen->flexion), row.gesture);
    }
  }
}

// Coming into sight a hand asks for nothing; then gestures do, and the button.
TEST(HeadsetUser, BecomesInputAndWishes) {
  HeadsetUser headset;
  DeviceRig rig(ClientConfig(), &headset);
  std::int64_t now = 1'000'000'000;
  const auto wishes = [&](double flexion, std::uint32_t buttons) {
    TrackedUser user;
    user.time_ns = now += 10'000'000;
    user.head = somewhere;
    user.hands[left_hand].emplace();
    user.hands[left_hand]->wrist = somewhere;
    user.hands[left_hand]->flexion.fill(flexion);
    user.hands[left_hand]->buttons = buttons;
    headset.put(user);
    EXPECT_TRUE(rig.poll(now));
    std::vector<GestureEvent> out;
    for (const GestureTrigger& trigger : rig.take_triggers()) {
      EXPECT_EQ(trigger.hand, left_hand);
      out.push_back(trigger.event);
    }
    return out;
  };
  using Wishes = std::vector<GestureEvent>;
  EXPECT_EQ(wishes(1, menu_button), Wishes{});
  EXPECT_EQ(wishes(0.5, 0), Wishes{});
  EXPECT_EQ(wishes(0, 0), Wishes{GestureEvent::release});
  EXPECT_EQ(wishes(0, menu_button), Wishes{GestureEvent::panel});
  EXPECT_EQ(wishes(0, menu_button), Wishes{});
  EXPECT_EQ(wishes(1, 0), Wishes{GestureEvent::grasp});
  EXPECT_TRUE(rig.input().head_tracked);
  EXPECT_TRUE(rig.input().hands[left_hand].tracked);
  EXPECT_FALSE(rig.input().hands[right_hand].tracked);
  EXPECT_EQ(rig.input().hands[left_hand].pose.p, somewhere.p);
  EXPECT_EQ(rig.input().hands[left_hand].flexion[2], 1);
  now += 300'000'000;
  EXPECT_FALSE(rig.poll(now));
  EXPECT_FALSE(rig.input().head_tracked);
  EXPECT_FALSE(rig.input().hands[left_hand].tracked);
  EXPECT_EQ(wishes(1, 0), Wishes{});
}

// What is at an angle of the field of view is at the picture's rim.
TEST(HeadsetEye, AsymmetricFieldsOfViewFillThePicture) {
  const EyeView eye{somewhere, -0.85, 0.70, 0.72, -0.80};
  ASSERT_TRUE(is_usable(eye));
  const DrawCamera camera = camera_of(eye, 320, 320, 240);
  EXPECT_EQ(camera.x, 320);
  EXPECT_EQ(camera.width, 320);
  EXPECT_EQ(camera.height, 240);
  const auto clip = [&](double right, double up) {
    const Vec3 place = somewhere * (2.5 * Vec3(std::tan(right), std::tan(up), -1));
    const Eigen::Vector4d seen = view_projection_of(camera) * place.homogeneous();
    return Eigen::Vector2d(seen.x() / seen.w(), seen.y() / seen.w());
  };
  EXPECT_LT((clip(-0.85, -0.80) - Eigen::Vector2d(-1, -1)).norm(), 1e-9);
  EXPECT_LT((clip(0.70, 0.72) - Eigen::Vector2d(1, 1)).norm(), 1e-9);
  EXPECT_GT(clip(0, 0).x(), 0.1);  // straight ahead isn't the middle
}

// Words are seen a metre away, whatever the eyes' fields of view.
TEST(HeadsetEye, WordsStandWhereBothEyesMeet) {
  const double half = 0.032;  // m, of the eyes' distance
  DrawList list;
  for (const double side : {-half, half}) {
    const Pose pose = somewhere * Pose{{side, 0, 0}, Quat::Identity()};
    const EyeView eye =
        side < 0 ? EyeView{pose, -0.85, 0.70, 0.72, -0.80} : EyeView{pose, -0.70, 0.85, 0.72, -0.80};
    list.cameras.push_back(camera_of(eye, side < 0 ? 0 : 320, 320, 320));
  }
  add_headset_text(list, "");
  EXPECT_TRUE(list.texts.empty());
  add_headset_text(list, "here");
  ASSERT_EQ(list.texts.size(), 1U);
  EXPECT_FALSE(list.texts[0].overlay);
  for (const DrawCamera& camera : list.cameras) {
    const Vec3 seen = camera.pose.inverse() * list.texts[0].at;
    EXPECT_NEAR(std::abs(seen.x() / seen.z()), half, 1e-9);
    EXPECT_LT(seen.z(), 0);
    const Eigen::Vector4d clip = view_projection_of(camera) * list.texts[0].at.homogeneous();
    EXPECT_LT(std::abs(clip.y() / clip.w()), 0.6);
  }
}

// A text of 13 points is as high to the wearer in each headset that has the pixels.
TEST(HeadsetEye, TextsAreAsLargeWhateverThePixels) {
  const EyeView eye{{}, -0.85, 0.70, 0.72, -0.80};
  const double tangents = std::tan(0.72) + std::tan(0.80);
  for (const int pixels : {1200, 1600, 2160, 4000})
    EXPECT_NEAR(13 * headset_pixels_per_point(camera_of(eye, 0, pixels, pixels)) * tangents / pixels,
                13.0 / 600, 1e-12);
  EXPECT_EQ(headset_pixels_per_point(camera_of(eye, 0, 320, 320)), 1);  // fewer pixels couldn't be read
}

TEST(HeadsetEye, GarbageIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const EyeView& eye :
       {EyeView{{}, nan, 0.7, 0.7, -0.7}, EyeView{{}, -0.7, 0.7, 0.7, 0.8}, EyeView{{}, 0.7, -0.7, 0.7, -0.7},
        EyeView{{}, -1.6, 0.7, 0.7, -0.7}, EyeView{{{nan, 0, 0}, Quat::Identity()}, -0.7, 0.7, 0.7, -0.7}})
    EXPECT_FALSE(is_usable(eye));
}

}  // namespace
}  // namespace prosector
