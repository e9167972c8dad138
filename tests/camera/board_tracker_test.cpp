#include "drivers/camera/tags/board_tracker.h"

#include <gtest/gtest.h>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/one_euro.h"
#include "drivers/camera/base/undistorter.h"
#include "tests/camera/tag_cases.h"
#include "twins/camera/synthetic_camera.h"

namespace prosector {
namespace {

/// Shows a scene to a tracker, picture by picture.
class Watcher {
 public:
  explicit Watcher(const Board& board) : straightener_(usual_lens()), finder_({}), tracker_(board) {
    optics_.bent = usual_lens();
    optics_.straight = straightener_.lens();
  }
  /// `copied`: codes of tags of which another copy is detected in the picture's corner.
  std::optional<TrackedBoard> see(const Image& image, double seconds, const std::vector<int>& copied = {}) {
    TagImage picture{grey_of(image), {}, {}, static_cast<std::int64_t>(1e9 * seconds)};
    picture.straight = straightener_.straight(picture.bent);
    picture.tags = finder_.find(picture.straight);
    for (const int code : copied) picture.tags.push_back({code, {{{2, 12}, {12, 12}, {12, 2}, {2, 2}}}, 100});
    return tracker_.update(picture, optics_);
  }

 private:
  Undistorter straightener_;
  TagDetector finder_;
  TagOptics optics_;
  BoardTracker tracker_;
};

/// A tablet whose tags a hand covers, all but their rims' corners, once in a while.
TEST(BoardTracker, FollowsWhereTagsCannotBeReadForAWhile) {
  const Board board = grid_board("tablet", {});
  SyntheticScene scene = usual_scene(usual_lens());
  scene.rays = 3;
  Carrier carrier;
  carrier.motion.emplace();
  carrier.motion->add(0, 0, Pose{{-0.05, 0, -0.6}, Quat::Identity()});
  carrier.motion->add(0, 1, Pose{{0.05, 0, -0.6}, Quat::Identity()});
  const std::size_t index = scene.add_board(board, carrier);
  SyntheticScene covered = scene;
  for (const BoardTag& tag : board.tags) {
    // A disc's worth of the code, not of the border.
    TexturedQuad spot{index, tag.pose, 0.7 * tag.size, 0.7 * tag.size, nullptr, true};
    spot.pose.p.z() += 1e-4;
    spot.texture =
        std::make_shared<Texture>(Image{1, 1, {25, 25, 25}}, false, Response(scene.sensor.response));
    covered.things.push_back(spot);
  }
  const SceneRenderer open(scene), hidden(covered);
  Watcher watcher(board);
  for (std::uint64_t k = 0; k < 28; ++k) {
    const bool hides = k >= 3 && k < 23;
    const double seconds = scene.seconds_of(k);
    const auto at = watcher.see((hides ? hidden : open).paint(k), seconds);
    const bool lost = hides && seconds - scene.seconds_of(2) > BoardTracker::max_flow_time - 1e-3;
    ASSERT_EQ(at.has_value(), !lost) << k;
    if (!at) continue;
    EXPECT_EQ(at->followed, hides) << k;
    const SyntheticTruth truth = scene.truth(seconds);
    const Vec3 off = at->camera_board.p - (truth.room_camera.inverse() * truth.room_things[index]).p;
    EXPECT_LT(off.head<2>().norm(), 2e-4) << k;
  }
}

/// Blur that hides all edges: nothing is told rather than something wrong.
TEST(BoardTracker, TellsNothingWhereEdgesAreGone) {
  const Board board = grid_board("tablet", {});
  SyntheticScene scene = usual_scene(usual_lens());
  scene.rays = 3;
  scene.exposure = 0.016;
  Carrier carrier;
  carrier.motion.emplace();
  carrier.motion->add(0, 0, Pose{{-0.05, 0, -0.6}, Quat::Identity()});
  carrier.motion->add(0, 0.3, Pose{{0.05, 0, -0.6}, Quat::Identity()});
  const std::size_t index = scene.add_board(board, carrier);
  const SceneRenderer painter(scene);
  Watcher watcher(board);
  int lost = 0;
  for (std::uint64_t k = 0; k < 12; ++k) {
    const double seconds = scene.seconds_of(k);
    const auto at = watcher.see(painter.paint(k), seconds);
    if (!at) ++lost;
    if (!at) continue;
    const SyntheticTruth truth = scene.truth(seconds);
    const Vec3 off = at->camera_board.p - (truth.room_camera.inverse() * truth.room_things[index]).p;
    EXPECT_LT(off.head<2>().norm(), 1e-3) << k;
  }
  EXPECT_GT(lost, 0);
  EXPECT_LT(lost, 8);
}

TEST(BoardTracker, FitsTheEdgesOfATagOnceWhoseCodeIsDetectedTwice) {
  const Board board = grid_board("four tags", {2, 2, 0.03, 0.008, 7});
  SyntheticScene scene = usual_scene(usual_lens());
  scene.rays = 3;
  Carrier carrier;
  carrier.pose = {{0.02, 0.01, -0.6}, Quat(Eigen::AngleAxisd(30 * degree, Vec3::UnitY()))};
  scene.add_board(board, carrier);
  const Image image = SceneRenderer(scene).paint(0);
  const auto once = Watcher(board).see(image, 0), twice = Watcher(board).see(image, 0, {7, 10});
  ASSERT_TRUE(once && twice && once->spread && twice->spread);
  EXPECT_EQ(once->twice, 0);
  EXPECT_EQ(twice->twice, 2);
  EXPECT_NEAR(twice->spread->trace() / once->spread->trace(), 1, 0.1);
}

TEST(BoardTracker, OfBothPosesThatLookAlikeItKeepsOne) {
  const Board board = grid_board("tag", {1, 1, 0.06, 0.02, 7});
  SyntheticScene scene = usual_scene(usual_lens());
  scene.rays = 3;
  Carrier carrier;
  carrier.pose = {{0.02, 0.01, -0.9}, Quat(Eigen::AngleAxisd(20 * degree, Vec3::UnitY()))};
  const std::size_t index = scene.add_board(board, carrier);
  const SceneRenderer painter(scene);
  Watcher watcher(board);
  const SyntheticTruth truth = scene.truth(0);
  const Quat right = (truth.room_camera.inverse() * truth.room_things[index]).q;
  std::optional<Quat> before;
  int jumps = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    const auto at = watcher.see(painter.paint(k), scene.seconds_of(k));
    ASSERT_TRUE(at);
    if (before && at->camera_board.q.angularDistance(*before) > 15 * degree) ++jumps;
    before = at->camera_board.q;
  }
  EXPECT_LE(jumps, 1);
  EXPECT_LT(before->angularDistance(right), 15 * degree);
}

TEST(PoseFilter, SmoothsWhatRestsAndFollowsWhatMoves) {
  Random random(3);
  PoseFilter filter;
  constexpr std::int64_t step_ns = 33'333'333;
  double in = 0, out = 0;
  std::int64_t now_ns = 0;
  for (int k = 0; k < 400; ++k, now_ns += step_ns) {
    const Vec3 noise = random.point(1e-4);
    const Pose smooth = filter.update({noise, Quat::Identity()}, now_ns);
    if (k < 50) continue;
    in += noise.squaredNorm();
    out += smooth.p.squaredNorm();
  }
  EXPECT_LT(std::sqrt(out / in), 0.4);
  // At 0.44 m/s it lags by some 15 ms; its turn by as little.
  Pose last;
  double x = 0, angle = 0;
  for (int k = 0; k < 60; ++k, now_ns += step_ns) {
    x += 0.44 / 30;
    angle += 3.0 / 30;
    last = filter.update({{x, 0, 0}, Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))}, now_ns);
  }
  EXPECT_LT((x - last.p.x()) / 0.44, 0.02);
  EXPECT_LT(last.q.angularDistance(Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()))) / 3.0, 0.02);
  // After a gap, and where time goes back, it begins anew.
  EXPECT_EQ(filter.update({{9, 9, 9}, Quat::Identity()}, now_ns + 2'000'000'000).p.x(), 9);
  EXPECT_EQ(filter.update({{5, 9, 9}, Quat::Identity()}, now_ns).p.x(), 5);
}

TEST(SyntheticCamera, RunsInRealTimeAndFailsAsItsSceneAsks) {
  SyntheticScene scene = usual_scene(usual_lens().scaled(160, 120));
  scene.rays = 1;
  scene.faults = {
      {CameraFault::black, 0.2, 0.4}, {CameraFault::resized, 0.4, 0.6}, {CameraFault::unplugged, 0.8, 100}};
  SyntheticCamera camera(scene, monotonic_ns());
  std::int64_t last_ns = 0;
  std::uint64_t next = 0;
  int black = 0, resized = 0;
  try {
    for (;;) {
      const auto frame = camera.next(std::chrono::milliseconds(200));
      ASSERT_TRUE(frame);
      EXPECT_GT(frame->time_ns, last_ns);
      EXPECT_GE(frame->number, next);
      EXPECT_LE(frame->time_ns, monotonic_ns());
      last_ns = frame->time_ns;
      next = frame->number + 1;
      resized += frame->image.width == 80 ? 1 : 0;
      black += frame->image.rgb.front() == 0 && frame->image.rgb.back() == 0 ? 1 : 0;
    }
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("unplugged"), std::string::npos);
  }
  EXPECT_GT(black, 0);
  EXPECT_GT(resized, 0);
}

}  // namespace
}  // namespace prosector
