// A face as a device: our own face before a synthetic camera in real time, its faults, and how far off the
// eyes are.
#include "drivers/camera/devices/face_device.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "idl/message.h"
#include "tests/hands/face_errors.h"
#include "tests/real_data.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {
namespace {

constexpr double degree = 0.01745329252;

double middle_of(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 1e9 : values[values.size() / 2];
}

class OwnFace : public testing::Test {
 protected:
  void SetUp() override {
    if (net_.empty()) GTEST_SKIP() << "no face_short_range.tflite: deploy/fetch_models.sh";
  }
  FaceErrors errors(FaceCase what) const {
    what.places = std::min(what.places, 3);  // the bench looks at more
    static const auto face = std::make_shared<const FaceMesh>(make_face(0.06));
    return face_errors(what, face, std::filesystem::path(net_).parent_path());
  }
  const std::string net_ = find_in_data("face_short_range.tflite");
};

TEST_F(OwnFace, IsSeenFromTheScreenWithinADegreeAtRest) {
  for (const FaceCase& what :
       {FaceCase{}, FaceCase{.distance = 0.45}, FaceCase{.distance = 0.8, .aside = -0.1},
        FaceCase{.yaw = 0.3}, FaceCase{.aside = 0.2, .yaw = -0.3}}) {
    const FaceErrors found = errors(what);
    SCOPED_TRACE(testing::Message() << what.distance << " m, " << what.aside << " aside, turned by "
                                    << what.yaw);
    EXPECT_EQ(found.seen, found.pictures);
    EXPECT_LT(middle_of(found.gaze), 1 * degree);
    EXPECT_LT(middle_of(found.depth), 60) << "mm";
    EXPECT_LT(found.rest_along, found.jitter_along);
  }
}

TEST_F(OwnFace, LagsLittleWhereItMoves) {
  const FaceErrors found = errors({.aside = -0.1, .speed = 0.3, .places = 1, .pictures = 30});
  EXPECT_GT(found.seen, 25);
  EXPECT_LT(middle_of(found.lag), 0.06) << "s";
}

TEST_F(OwnFace, ComesFromASyntheticCameraInRealTimeAndAfterFaults) {
  const std::filesystem::path scene = std::filesystem::path(testing::TempDir()) / "own_face.toml";
  std::ofstream(scene) << "[[camera]]\nrate = 10\nrays = 1\nwidth = 320\nheight = 240\nfocal = 300\n"
                          "position = [0, 0.17, 0]\norientation = [0, 0, 1, 0]\n"
                          "[[face]]\nposition = [0.05, 0.02, 0.6]\neye_distance = 0.06\n"
                          "[[fault]]\nkind = \"torn\"\nfrom = 1\nto = 1.5\n"
                          "[[fault]]\nkind = \"resized\"\nfrom = 1.5\nto = 2\n"
                          "[[fault]]\nkind = \"black\"\nfrom = 2\nto = 4\n"
                          "[[fault]]\nkind = \"unplugged\"\nfrom = 4.2\nto = 5\n";
  Placement placement;
  placement.room_device = {{0, 0.17, 0}, Quat(0, 0, 1, 0)};
  const auto device = open_face("synthetic:" + scene.string(), placement, {}, {.eye_distance = 0.06});
  std::array<std::optional<DeviceSample>, 3> last;
  std::vector<std::string> words;
  const std::int64_t start = monotonic_ns();
  std::int64_t back_ns = 0;  // since when it streams after it was unplugged
  std::vector<DeviceSample> samples;
  while (seconds_since(start) < 60 && !(back_ns > 0 && last[0] && last[0]->time_ns > back_ns)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    samples.clear();
    device->poll(samples);
    for (const DeviceSample& sample : samples) {
      ASSERT_LT(sample.station, last.size());
      EXPECT_TRUE(sample.has_pose && sample.pose.p.allFinite());
      if (last[sample.station]) {
        EXPECT_GT(sample.time_ns, last[sample.station]->time_ns);
      }
      last[sample.station] = sample;
    }
    const DeviceStatus status = device->status();
    if (words.empty() || words.back() != status.message) words.push_back(status.message);
    if (status.reopens > 0 && status.health == DeviceHealth::streaming && back_ns == 0)
      back_ns = monotonic_ns();
  }
  ASSERT_TRUE(last[0] && last[1] && last[2]);
  const auto said = [&](const std::string& what) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& line) { return line.find(what) != std::string::npos; });
  };
  EXPECT_TRUE(said("no face detected"));
  EXPECT_TRUE(said("unplugged"));
  EXPECT_GT(back_ns, 0);
  const Vec3 eyes(0.05, 0.02, 0.6);
  EXPECT_LT((last[0]->pose.p - eyes).head<2>().norm(), 0.03) << "m";
  EXPECT_NEAR(last[0]->pose.p.z(), eyes.z(), 0.1) << "m";
  EXPECT_LT(last[0]->pose.q.angularDistance(Quat::Identity()), 0.35) << "rad: it looks at the screen";
  EXPECT_NEAR((last[1]->pose.p - last[2]->pose.p).norm(), 0.06, 1e-6) << "m";
  EXPECT_GT(last[1]->pose.p.x(), last[2]->pose.p.x()) << "the right eye is to the right";
}

TEST_F(OwnFace, IsntThereInAnEmptyRoom) {
  const std::filesystem::path scene = std::filesystem::path(testing::TempDir()) / "no_face.toml";
  std::ofstream(scene) << "[[camera]]\nrate = 10\nrays = 1\nwidth = 320\nheight = 240\nfocal = 300\n";
  const auto device = open_face("synthetic:" + scene.string(), {}, {}, {});
  std::vector<DeviceSample> samples;
  const std::int64_t start = monotonic_ns();
  while (seconds_since(start) < 20 && device->status().message.find("no face") == std::string::npos) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    device->poll(samples);
  }
  EXPECT_TRUE(samples.empty());
  EXPECT_NE(device->status().message.find("no face"), std::string::npos);
}

TEST(FaceScenes, SayWhatACtNeeds) {
  const std::filesystem::path scene = std::filesystem::path(testing::TempDir()) / "ct_face.toml";
  std::ofstream(scene) << "[[face]]\nct = true\n";
  if (!find_in_data("head.nii").empty()) GTEST_SKIP() << "head.nii is there";
  try {
    (void)SyntheticScene::load(scene);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("fetch_anatomy.sh"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace prosector
