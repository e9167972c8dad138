#include <gtest/gtest.h>

#include "drivers/camera/base/undistorter.h"
#include "drivers/camera/tags/board_tracker.h"
#include "drivers/fitting/rigid_fit.h"
#include "tests/camera/tag_cases.h"
#include "tests/camera/tag_errors.h"
#include "tests/folders.h"

namespace prosector {
namespace {

constexpr double distance = 0.6;  // m

Board phantom() {
  return load_board(source_path("deploy/cameras/phantom.toml"));
}

/// Points 50 mm from the cube's middle, inside and behind it as the camera sees it.
std::vector<Vec3> targets() {
  return {{0, 0, -0.05}, {0, -0.05, 0}, {0.03, -0.03, -0.026}, {-0.05, 0, 0}};
}

/// A phantom that stands on a table and shows the camera its top and two of its sides.
Pose standing_phantom(Random& random) {
  Pose pose;
  pose.p = {random.uniform(-0.08, 0.08), random.uniform(-0.06, 0.06), -distance};
  pose.q = Quat(Eigen::AngleAxisd(random.uniform(0.4, 0.7), Vec3::UnitX())) *
           Quat(Eigen::AngleAxisd(random.uniform(-0.7, 0.7), Vec3::UnitY()));
  return pose;
}

struct PhantomErrors {
  std::vector<double> found, told;  // mm at targets
  int seen = 0;
};

PhantomErrors phantom_errors(int places) {
  Random random(17);
  const Board board = phantom();
  const Lens lens = usual_lens();
  const Undistorter straightener(lens);
  const TagDetector finder({1});
  PhantomErrors out;
  for (int k = 0; k < places; ++k) {
    const Pose truth = standing_phantom(random);
    SyntheticScene scene = usual_scene(lens);
    scene.sensor.seed = static_cast<unsigned>(k + 1);
    Carrier carrier;
    carrier.pose = truth;
    scene.add_board(board, carrier);
    TagImage picture;
    picture.bent = grey_of(SceneRenderer(scene).paint(0));
    picture.straight = straightener.straight(picture.bent);
    picture.tags = finder.find(picture.straight);
    const auto seen = BoardTracker(board).update(picture, {lens, straightener.lens(), scene.sensor.response});
    if (!seen || !seen->spread) continue;
    ++out.seen;
    for (const Vec3& target : targets()) {
      out.found.push_back(1e3 * (device_camera * (seen->camera_board * target) - truth * target).norm());
      out.told.push_back(1e3 * error_at(*seen->spread, seen->camera_board * target));
    }
  }
  return out;
}

TEST(Phantom, TargetsInsideAndBehindAreKnownBelowAMillimetre) {
  constexpr int places = 8;
  const PhantomErrors errors = phantom_errors(places);
  const double median = quantile(errors.found, 0.5), most = quantile(errors.found, 1);
  std::cout << median << " mm median, " << most << " mm at most, told " << quantile(errors.told, 0.5)
            << " mm\n";
  // A single picture of a body may be refused.
  EXPECT_GE(errors.seen, places - 1);
  EXPECT_LE(most, 1);
  EXPECT_LE(median, 0.3);
  // No surer than it is, and not far less sure.
  EXPECT_LT(median / quantile(errors.told, 0.5), 3);
  EXPECT_GT(median / quantile(errors.told, 0.5), 0.2);
}

// The other way: points of the phantom are touched with a tracked tip.
TEST(Phantom, TouchedPointsTellTheErrorAtTargets) {
  Random random(4);
  double squares = 0, told = 0;
  constexpr int tries = 100;
  for (int k = 0; k < tries; ++k) {
    const Pose room_phantom = standing_phantom(random);
    std::vector<TouchedPoint> touched;
    for (const double x : {-0.03, 0.03})
      for (const double y : {-0.03, 0.03})
        for (const double z : {-0.03, 0.03})
          touched.push_back({Vec3(x, y, z), room_phantom * Vec3(x, y, z) + random.point(0.0008)});
    const RigidFit fit = fit_rigid(touched);
    for (const Vec3& target : targets()) {
      squares += (fit.room_device * target - room_phantom * target).squaredNorm();
      told += std::pow(fit.expected_error(fit.room_device * target), 2);
    }
  }
  const double rms = std::sqrt(squares / (4 * tries));
  std::cout << "touched: " << 1e3 * rms << " mm RMS at targets\n";
  EXPECT_LT(rms, 1e-3);
  EXPECT_NEAR(std::sqrt(told / (4 * tries)) / rms, 1, 0.15);
}

}  // namespace
}  // namespace prosector
