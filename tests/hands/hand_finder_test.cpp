// Bare hands found in pictures of our own, and what pictures without hands do.
#include "drivers/camera/hands/hand_finder.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "drivers/camera/hands/hand_tracker.h"
#include "drivers/device/gesture_flexions.h"
#include "tests/gesture_bends.h"
#include "tests/hands/hand_trial.h"

namespace prosector {
namespace {

const HandPainter& painter() {
  static const HandPainter made;
  return made;
}

class FetchedNets : public testing::Test {
 protected:
  void SetUp() override {
    if (nets_.empty()) GTEST_SKIP() << "no palm_full.tflite: deploy/fetch_models.sh";
  }
  std::filesystem::path nets_ = fetched_nets();
};

using HandsInPictures = FetchedNets;

TEST_F(HandsInPictures, AreSeenAtFirstSight) {
  const HandTrial trial = first_sight(nets_, HandNets::full, painter(), 40, 11);
  EXPECT_GE(trial.seen, 38u);
  EXPECT_GE(trial.right_points, 28u)
      << "palms are taken for backs now and then, and fingers mixed up with them";
  EXPECT_GE(trial.right_side, 30u);
  EXPECT_LT(trial.points.at(0.5), 0.025) << "of the hand's length";
  EXPECT_LT(trial.flexion.at(0.5), 0.08);
  EXPECT_LT(trial.lateral.at(0.5), 0.007);
  EXPECT_LT(trial.depth.at(0.5), 0.03);
}

TEST_F(HandsInPictures, AreFollowedWithoutALoss) {
  const HandTrial trial = followed_hand(nets_, HandNets::full, painter(), 45, 1, 1);
  EXPECT_EQ(trial.seen, trial.pictures);
  EXPECT_GE(trial.right_side, trial.pictures - 2);
  EXPECT_LE(trial.palm_runs, 1 + trial.pictures / 10)
      << "looked for once, and now and then for a second hand";
  EXPECT_LT(trial.flexion.at(0.5), 0.08);
}

// Seeds that nothing was tuned on: seldom anything but what was made is told.
TEST_F(HandsInPictures, TellEachGestureOfTheTable) {
  const GestureTrial trial = made_gestures(nets_, HandNets::full, painter(), 2, 301);
  double right = 0;
  std::size_t gestures = 0;
  for_gestures([&](const GestureRow& row) {
    EXPECT_GE(trial.right_share(row.gesture), 0.5) << row.name;
    right += trial.right_share(row.gesture);
    ++gestures;
  });
  EXPECT_GE(right / static_cast<double>(gestures), 0.95);
}

TEST(HiddenBends, GrowAndEndWhereTheyBegan) {
  std::array<double, fingers> before = gesture_flexions({});
  for (const double bend : before) EXPECT_EQ(bend, 0);
  for (int k = 1; k <= 100; ++k) {
    std::array<double, fingers> seen{};
    seen.fill(0.01 * k);
    const auto now = gesture_flexions(seen);
    for (std::size_t f = 0; f < fingers; ++f) {
      EXPECT_GE(now[f], before[f]) << f;
      EXPECT_LE(now[f], 1) << f;
    }
    before = now;
  }
  for (const double bend : before) EXPECT_EQ(bend, 1);
  for (const double bend : gesture_flexions({9, 9, 9, -9, -9})) EXPECT_TRUE(bend == 0 || bend == 1);
}

Gesture gesture_of(const std::array<double, fingers>& seen) {
  return GestureDetector(GestureThresholds{}).update(gesture_flexions(seen));
}

TEST(HiddenBends, FourFingersHalfBentAlikeAreAFist) {
  EXPECT_EQ(gesture_of({0.5, 0.44, 0.47, 0.45, 0.5}), Gesture::fist) << "from behind";
  EXPECT_NE(gesture_of({0.5, 0.36, 0.47, 0.45, 0.5}), Gesture::fist) << "a finger apart";
  EXPECT_NE(gesture_of({0.5, 0.38, 0.4, 0.39, 0.4}), Gesture::fist) << "a hand at rest";
  EXPECT_EQ(gesture_of({0.5, 0.1, 0.51, 0.52, 0.51}), Gesture::point);
}

/// Turns the back of a hand to the camera above it, its fingers away from the camera by that angle.
Quat from_behind(double away) {
  Mat3 upright;
  upright << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return (Quat(Eigen::AngleAxisd(-away, Vec3::UnitX())) * Eigen::AngleAxisd(3.14159265, Vec3::UnitY()) *
          Quat(upright))
      .normalized();
}

TEST_F(HandsInPictures, AreFistsFromBehindToo) {
  HandTracker tracker(nets_, HandNets::full, 1);
  std::int64_t now_ns = 0;
  for (const double away : {0.3, 0.5, 0.7}) {
    Random random(41);
    PosedHand hand{right_hand, {Vec3::Zero(), from_behind(away)}, {0.1, 0.1, 0.1, 0.1, 0.1}};
    hand.camera_wrist.p = Vec3(0.02, 0.02, 0.5) - hand.camera_wrist.q * Vec3(0, 0, -0.09);
    HandScene scene = random_scene(random, hand);
    scene.light = {Vec3(0.2, -0.5, -0.8).normalized(), 0.5};
    scene.wall = {0.1F, 0.15F, 0.2F};
    tracker.set_camera_setup(0, {scene.lens, {}});
    now_ns += 1'000'000'000;
    GestureDetector detector(GestureThresholds{});
    std::vector<Gesture> all;
    for (int k = 0; k < 10; ++k) {
      const double closed = std::clamp((k - 2) / 4.0, 0.0, 1.0);
      for (double& bend : scene.hands[0].flexion) bend = 0.1 + 0.9 * closed;
      scene.hands[0].flexion[0] = 0.1 + 0.7 * closed;
      now_ns += 66'666'667;
      for (const TrackedHand& tracked : tracker.see(0, {painter().paint(scene, random), now_ns, 0}))
        all.push_back(detector.update(gesture_flexions(tracked.flexion)));
    }
    ASSERT_GE(all.size(), 8u) << away;
    EXPECT_EQ(all.front(), Gesture::flat) << away;
    EXPECT_EQ(without_thumb(all.back()), Gesture::fist) << away;
  }
}

TEST_F(HandsInPictures, AreTwoOfTwoSides) {
  Random random(5);
  HandScene scene = random_scene(random, {});
  scene.light.ambient = 0.5;
  scene.light.towards = Vec3(0.2, -0.5, -0.8).normalized();
  scene.wall = {0.1F, 0.15F, 0.2F};
  PosedHand left{left_hand, {}, {0.1, 0.1, 0.1, 0.1, 0.1}}, right = left;
  right.hand = right_hand;
  Mat3 upright;  // backs to the camera, fingers up
  upright << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Quat back_shown = (Quat(Eigen::AngleAxisd(3.14159265, Vec3::UnitY())) * Quat(upright)).normalized();
  left.camera_wrist = {Vec3(-0.12, 0.08, 0.5), back_shown};
  right.camera_wrist = {Vec3(0.12, 0.08, 0.5), back_shown};
  scene.hands = {left, right};
  HandFinder finder(nets_, HandNets::full);
  for (int k = 0; k < 3; ++k) {
    const auto hands = finder.find(painter().paint(scene, random));
    ASSERT_EQ(hands.size(), 2u);
    EXPECT_NE(hands[0].left, hands[1].left);
    for (const DetectedHand& hand : hands) {
      const auto truth = true_points(scene, scene.hands[hand.points[9].x() < 320 ? 0 : 1]);
      EXPECT_LT((hand.points[9] - truth[9]).norm(), 12) << "pixels";
    }
  }
}

TEST_F(HandsInPictures, AreNoneInPicturesOfNothing) {
  HandFinder finder(nets_, HandNets::lite);
  Random random(6);
  std::vector<Image> pictures = {
      {}, {640, 480, {}}, {-3, 5, {}}, {1, 1, {1, 2, 3}}, {640, 480, std::vector<std::uint8_t>(640 * 480)}};
  pictures.push_back({320, 240, std::vector<std::uint8_t>(320 * 240 * 3)});
  pictures.push_back(pictures.back());
  for (auto& byte : pictures.back().rgb) byte = static_cast<std::uint8_t>(random.below(256));
  for (const Image& picture : pictures) EXPECT_TRUE(finder.find(picture).empty()) << picture.width;
}

TEST_F(HandsInPictures, ComeBackAfterABlackPicture) {
  HandFinder finder(nets_, HandNets::lite);
  Random random(7);
  HandScene scene = random_scene(random, random_hand(random, 0.4, 0.5));
  scene.hands[0].flexion = {};
  const Image good = painter().paint(scene, random);
  Image small{320, 240, std::vector<std::uint8_t>(320 * 240 * 3)}, black = good;
  std::fill(black.rgb.begin(), black.rgb.end(), std::uint8_t{0});
  ASSERT_EQ(finder.find(good).size(), 1u);
  EXPECT_TRUE(finder.find(black).empty());
  EXPECT_TRUE(finder.find(small).empty());
  EXPECT_EQ(finder.find(good).size(), 1u);
}

/// Returns the picture in so much less light.
Image dimmed(Image image, double light) {
  for (std::uint8_t& byte : image.rgb) byte = static_cast<std::uint8_t>(byte * light);
  return image;
}

TEST_F(HandsInPictures, AreFoundInDimLight) {
  HandFinder finder(nets_, HandNets::full);
  Random random(77);
  int bright = 0, dim = 0;
  for (int k = 0; k < 8; ++k) {
    const HandScene scene = random_scene(random, random_hand(random, 0.35, 0.7));
    const Image picture = painter().paint(scene, random);
    finder.forget();
    bright += !finder.find(picture).empty();
    finder.forget();
    dim += !finder.find(dimmed(picture, 0.12)).empty();
  }
  EXPECT_GE(bright, 7);
  EXPECT_GE(dim, bright - 1);
}

/// Shows a hand with its back to the camera there, fingers up.
PosedHand hand_at(std::size_t hand, const Vec3& place) {
  PosedHand out{hand, {}, {0.1, 0.1, 0.1, 0.1, 0.1}};
  out.camera_wrist = {place, from_behind(0)};
  return out;
}

TEST_F(HandsInPictures, AreNotThoseOfBystanders) {
  Random random(9);
  HandScene scene = random_scene(random, {});
  scene.light = {Vec3(0.2, -0.5, -0.8).normalized(), 0.5};
  scene.wall = {0.1F, 0.15F, 0.2F};
  const PosedHand far = hand_at(left_hand, {-0.3, 0, 1.6}), near = hand_at(right_hand, {0.1, 0.08, 0.5});
  HandTracker tracker(nets_, HandNets::full, 1);
  tracker.set_camera_setup(0, {scene.lens, {}});
  std::int64_t now_ns = 1'000'000'000;
  const auto see = [&](const std::vector<PosedHand>& hands) {
    scene.hands = hands;
    return tracker.see(0, {painter().paint(scene, random), now_ns += 33'333'333, 0});
  };
  EXPECT_TRUE(see({far}).empty());
  EXPECT_NE(std::string(tracker.lack()).find("tracker.farthest_hand"), std::string::npos) << tracker.lack();
  const auto both = see({far, near});
  ASSERT_EQ(both.size(), 1U);
  EXPECT_LT(both[0].wrist.p.z(), 0.8) << "m";
  EXPECT_STREQ(tracker.lack(), "");
  EXPECT_TRUE(see({}).empty());
  EXPECT_NE(std::string(tracker.lack()).find("no hand detected"), std::string::npos) << tracker.lack();
  HandTracker reaching(nets_, HandNets::full, 1, {1, 2.5});
  reaching.set_camera_setup(0, {scene.lens, {}});
  scene.hands = {far};
  EXPECT_EQ(reaching.see(0, {painter().paint(scene, random), now_ns, 0}).size(), 1U);
}

TEST_F(HandsInPictures, AreTheNearestTwo) {
  Random random(10);
  HandScene scene = random_scene(random, {});
  scene.light = {Vec3(0.2, -0.5, -0.8).normalized(), 0.5};
  scene.wall = {0.1F, 0.15F, 0.2F};
  const std::vector<PosedHand> bystander = {hand_at(left_hand, {-0.35, 0, 1}),
                                            hand_at(right_hand, {0.35, 0, 1})};
  HandFinder finder(nets_, HandNets::full);
  scene.hands = bystander;
  ASSERT_EQ(finder.find(painter().paint(scene, random)).size(), 2U);
  scene.hands.push_back(hand_at(right_hand, {0, 0.08, 0.45}));
  const Image picture = painter().paint(scene, random);
  bool is_taken = false;
  for (int k = 0; k < 31 && !is_taken; ++k)
    for (const DetectedHand& hand : finder.find(picture)) is_taken |= length_of_hand(hand.points) > 180;
  EXPECT_TRUE(is_taken) << "within a second";
}

TEST(HandFinder, SaysWhatItNeeds) {
  try {
    HandFinder("/nowhere", HandNets::full);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/palm_full.tflite"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("deploy/fetch_models.sh"), std::string::npos);
  }
}

TEST(ImageRegion, TakesATurnedSquare) {
  Image image{64, 48, {}};
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      for (const int c : {4 * x, 5 * y, 128}) image.rgb.push_back(static_cast<std::uint8_t>(c));
  Random random(8);
  for (int k = 0; k < 50; ++k) {
    const ImageRegion region{
        {random.uniform(25, 38), random.uniform(20, 28)}, random.uniform(10, 20), random.uniform(-3, 3)};
    const std::size_t size = 4 + random.below(20);
    std::vector<float> out(3 * size * size);
    sample_region(image, region, size, Outside::black, out);
    for (std::size_t p = 0; p < size * size; ++p) {
      const auto n = static_cast<double>(size);
      const Vec2 at = region.pixel(
          {(static_cast<double>(p % size) + 0.5) / n, (static_cast<double>(p / size) + 0.5) / n});
      ASSERT_NEAR(255 * out[3 * p], 4 * at.x(), 0.01);
      ASSERT_NEAR(255 * out[3 * p + 1], 5 * at.y(), 0.01);
      ASSERT_NEAR(255 * out[3 * p + 2], 128, 0.01);
    }
  }
}

TEST(ImageRegion, IsBrightenedWhereItIsDark) {
  const auto brightened = [](float level) {
    std::vector<float> pixels(300, 0.5F * level);
    std::fill_n(pixels.begin(), 60, level);  // a fifth of the pixels
    brighten(pixels);
    return std::pair(pixels.front(), pixels.back());
  };
  EXPECT_EQ(brightened(0.6F), std::pair(0.6F, 0.3F)) << "bright enough";
  EXPECT_NEAR(brightened(0.1F).first, 0.5, 0.02);
  EXPECT_NEAR(brightened(0.1F).second, 0.25, 0.01);
  EXPECT_LE(brightened(0.01F).first, 0.081) << "noise of the dark stays dark";
  EXPECT_EQ(brightened(0).first, 0);
}

TEST(ImageRegion, IsBlackOrItsEdgeOutside) {
  Image image{8, 8, std::vector<std::uint8_t>(8 * 8 * 3, 200)};
  std::vector<float> out(3 * 16);
  for (const Outside outside : {Outside::black, Outside::edge}) {
    sample_region(image, {{1e5, -1e5}, 16, 0.3}, 4, outside, out);
    for (const float x : out) EXPECT_NEAR(255 * x, outside == Outside::black ? 0 : 200, 0.01);
  }
}

}  // namespace
}  // namespace prosector
