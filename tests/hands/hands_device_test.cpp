// Bare hands as a device: what comes of pictures in a row, of two cameras, of a synthetic camera in real
// time.
#include "drivers/camera/devices/hands_device.h"

#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "tests/hands/hand_trial.h"

namespace prosector {
namespace {

const HandPainter& shown_by() {
  static const HandPainter made;
  return made;
}

class BareHands : public testing::Test {
 protected:
  void SetUp() override {
    if (nets_.empty()) GTEST_SKIP() << "no palm_full.tflite: deploy/fetch_models.sh";
    scene_.lens = webcam();
    scene_.wall = {0.08F, 0.12F, 0.16F};
    scene_.light.towards = Vec3(0.3, -0.6, -0.75).normalized();
    Mat3 upright;  // the back to the camera, fingers up
    upright << -1, 0, 0, 0, 0, -1, 0, -1, 0;
    hand_.camera_wrist = {Vec3(0.03, 0.08, 0.5), Quat(upright).normalized()};
    hand_.flexion = {0.5, 0.05, 0.9, 0.9, 0.9};
  }
  Frame frame(std::uint64_t number, const Pose& camera_rig = {}) {
    scene_.hands = {hand_};
    scene_.camera_rig = camera_rig;
    return {shown_by().paint(scene_, random_), static_cast<std::int64_t>(number) * 33'333'333 + 1'000'000'000,
            number};
  }
  Vec3 off(const TrackedHand& tracked) const {
    return tracked.wrist * hand_palm(hand_.hand).center - hand_.camera_wrist * hand_palm(hand_.hand).center;
  }

  std::filesystem::path nets_ = fetched_nets();
  Random random_{31};
  HandScene scene_;
  PosedHand hand_;
};

TEST_F(BareHands, RestWhereTheyAre) {
  HandTracker tracker(nets_, HandNets::full, 1);
  tracker.set_camera_setup(0, {webcam(), {}});
  std::vector<Vec3> places;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const auto hands = tracker.see(0, frame(k));
    ASSERT_EQ(hands.size(), 1u) << k;
    EXPECT_EQ(hands[0].hand, right_hand);
    places.push_back(off(hands[0]));
    for (std::size_t f = 1; f < fingers; ++f) EXPECT_NEAR(hands[0].flexion[f], hand_.flexion[f], 0.25) << f;
  }
  EXPECT_LT(places.back().head<2>().norm(), 0.01) << "m";
  EXPECT_LT(std::abs(places.back().z()), 0.04) << "m";
  double sway = 0;
  for (std::size_t k = 10; k < places.size(); ++k) sway = std::max(sway, (places[k] - places.back()).norm());
  EXPECT_LT(sway, 0.01) << "m: smoothed";
}

TEST_F(BareHands, AreDeeperKnownByTwoCameras) {
  const Pose second = {Vec3(-0.12, 0, 0), Quat::Identity()};
  const Quat upright = hand_.camera_wrist.q;
  double depth_one = 0, depth_two = 0;
  std::size_t by_one = 0, by_two = 0;
  // Of a hand larger than the one assumed, as people's are, which one camera takes for a nearer one; in
  // several turns, as in a single one it may be right by luck.
  hand_.size = 1.06;
  for (const double turn : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
    hand_.camera_wrist.q = (Quat(Eigen::AngleAxisd(turn, Vec3(1, 1, 0).normalized())) * upright).normalized();
    HandTracker one(nets_, HandNets::full, 1), two(nets_, HandNets::full, 2);
    one.set_camera_setup(0, {webcam(), {}});
    two.set_camera_setup(0, {webcam(), {}});
    two.set_camera_setup(1, {webcam(), second});
    for (std::uint64_t k = 0; k < 4; ++k) {
      hand_.camera_wrist.p.z() = 0.45 + 0.005 * static_cast<double>(k);
      EXPECT_TRUE(two.see(1, frame(k, second)).empty() || k == 0)
          << "the first camera's pictures give the poses";
      const Frame first = frame(k);
      for (const TrackedHand& hand : one.see(0, first)) {
        depth_one += std::abs(off(hand).z());
        ++by_one;
      }
      for (const TrackedHand& hand : two.see(0, first)) {
        depth_two += std::abs(off(hand).z());
        by_two += hand.cameras == 2;
      }
    }
  }
  EXPECT_GE(by_one, 15u);
  EXPECT_GE(by_two, 16u);
  EXPECT_LT(depth_two / static_cast<double>(by_two), depth_one / static_cast<double>(by_one));
  EXPECT_LT(depth_two / static_cast<double>(by_two), 0.015) << "m";
}

TEST_F(BareHands, AreLostWithoutWordsAndFoundAgain) {
  HandTracker tracker(nets_, HandNets::lite, 1);
  tracker.set_camera_setup(0, {webcam(), {}});
  ASSERT_EQ(tracker.see(0, frame(0)).size(), 1u);
  Frame torn = frame(1);
  torn.image.rgb.resize(1000);
  EXPECT_TRUE(tracker.see(0, torn).empty());
  EXPECT_TRUE(tracker.see(0, {{}, 1, 2}).empty());
  EXPECT_EQ(tracker.see(0, frame(40)).size(), 1u);
}

/// Returns the picture with its rows from one on those of something else, as a camera's broken packets give.
Image torn_picture(const Image& image, int row, int shift) {
  Image out = image;
  const auto width = static_cast<std::size_t>(image.width);
  for (auto y = static_cast<std::size_t>(row); y < static_cast<std::size_t>(image.height); ++y)
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        out.rgb[3 * (y * width + x) + c] =
            image.rgb[3 * (y * width + (x + static_cast<std::size_t>(shift)) % width) + c];
  return out;
}

TEST_F(BareHands, StayWhereTheyAreWhileSinglePicturesAreTorn) {
  const Quat upright = hand_.camera_wrist.q;
  std::size_t reported = 0, pictures = 0;
  for (int way = 0; way < 4; ++way) {
    hand_.flexion.fill(way % 2 == 0 ? 0.1 : 0.8);
    hand_.camera_wrist.q = (Quat(Eigen::AngleAxisd(0.2 * way, Vec3::UnitZ())) * upright).normalized();
    HandTracker tracker(nets_, HandNets::full, 1);
    tracker.set_camera_setup(0, {webcam(), {}});
    const Frame whole = frame(0);
    std::optional<Pose> first;
    for (int k = 0; k < 32; ++k) {
      Frame shown = whole;
      shown.time_ns += k * 33'333'333;
      const bool torn = k % 4 == 3;
      if (torn) shown.image = torn_picture(whole.image, 120 + 7 * k, 60 + 31 * k % 300);
      for (const TrackedHand& hand : tracker.see(0, shown)) {
        if (hand.hand != hand_.hand) continue;
        ++reported;
        if (!first) first = hand.wrist;
        EXPECT_LT(hand.wrist.q.angularDistance(first->q), 0.8) << way << " " << k;
        EXPECT_LT((hand.wrist.p - first->p).norm(), 0.15) << way << " " << k;
      }
      ++pictures;
    }
  }
  EXPECT_GE(reported, pictures * 6 / 10);
}

TEST_F(BareHands, ComeFromASyntheticCameraInRealTime) {
  const std::filesystem::path folder = testing::TempDir();
  std::ofstream(folder / "bare_hands.csv")
      << "time,station,x,y,z,qw,qx,qy,qz,thumb,index,middle,ring,little\n"
         "0,1,0.1,1,0,0.70710678,0.70710678,0,0,0.2,0.05,0.9,0.9,0.9\n"
         "0,2,-0.1,1,0,0.70710678,0.70710678,0,0,0.1,0.05,0.05,0.05,0.05\n";
  std::ofstream(folder / "bare_hands.toml")
      << "ambient = 0.6\n[[camera]]\nrate = 15\nrays = 1\ndistortion = [-0.18, 0, 0, 0, 0]\n"
         "position = [0, 1.1, 0.55]\norientation = [1, 0, 0, 0]\n"
         "[[hand]]\nmotion = \"bare_hands.csv\"\nstation = 1\n"
         "[[hand]]\nleft = true\nmotion = \"bare_hands.csv\"\nstation = 2\n"
         "[[fault]]\nkind = \"black\"\nfrom = 1\nto = 1.4\n";
  Placement placement;
  placement.room_device = {Vec3(0, 1.1, 0.55), Quat::Identity()};
  const auto device = open_hands("synthetic:" + (folder / "bare_hands.toml").string(), placement, {}, {}, {});
  // Until each hand gave some records, however busy the machine is.
  std::vector<DeviceSample> samples;
  std::array<std::optional<DeviceSample>, 2> last;
  bool streamed = false;
  const std::int64_t start = monotonic_ns();
  const auto seen_enough = [&] {
    return last[0] && last[1] && last[0]->record >= 12 && last[1]->record >= 12;
  };
  while (!seen_enough() && seconds_since(start) < 60) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    samples.clear();
    device->poll(samples);
    streamed = streamed || device->status().health == DeviceHealth::streaming;
    for (const DeviceSample& sample : samples) {
      ASSERT_LT(sample.station, 2u);
      if (last[sample.station]) {
        EXPECT_GT(sample.time_ns, last[sample.station]->time_ns);
        EXPECT_EQ(sample.record, last[sample.station]->record + 1);
      }
      last[sample.station] = sample;
    }
  }
  EXPECT_TRUE(streamed) << device->status().message;
  for (const std::size_t station : {0u, 1u}) {
    ASSERT_TRUE(last[station]) << station;
    EXPECT_TRUE(last[station]->has_pose && last[station]->has_flexion);
    const Vec3 place = last[station]->pose.p - Vec3(station == 0 ? 0.1 : -0.1, 1, 0);
    EXPECT_LT(place.head<2>().norm(), 0.02) << "m";
    EXPECT_LT(std::abs(place.z()), 0.06) << "m, along the camera's axis";
  }
  EXPECT_EQ(last[0]->gesture, Gesture::thumb_index);
  EXPECT_EQ(last[1]->gesture, Gesture::flat);
}

TEST_F(BareHands, SayThatTheCameraIsAway) {
  const auto device = open_hands("/dev/no-such-camera", {}, {}, {}, {});
  std::vector<DeviceSample> samples;
  const std::int64_t start = monotonic_ns();
  while (device->status().health != DeviceHealth::absent && seconds_since(start) < 3)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  device->poll(samples);
  EXPECT_TRUE(samples.empty());
  EXPECT_EQ(device->status().health, DeviceHealth::absent);
  EXPECT_NE(device->status().message.find("no-such-camera"), std::string::npos);
}

TEST(HandsDevice, WantsOneCameraOrTwo) {
  for (const char* path : {"", ",", "0,", "0,1,2"})
    EXPECT_THROW(open_hands(path, {}, {}, {}, {}), InputError) << path;
}

}  // namespace
}  // namespace prosector
