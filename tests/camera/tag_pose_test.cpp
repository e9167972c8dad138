#include <gtest/gtest.h>

#include "drivers/camera/base/undistorter.h"
#include "tests/camera/tag_errors.h"

namespace prosector {
namespace {

Board one_tag() {
  return grid_board("tag", {1, 1, 0.08, 0.02, 7});
}
Board tablet() {
  return grid_board("tablet", {});
}

class TagResponse : public testing::TestWithParam<double> {};

TEST_P(TagResponse, OneTagAtArmsLengthIsFoundToThirdsOfAMillimetre) {
  TagCase what{one_tag()};
  what.distance = 0.8;
  what.most_tilt = 60 * degree;
  what.response = what.assumed = GetParam();
  const TagErrors errors = tag_errors(what);
  EXPECT_EQ(errors.seen, what.places);
  EXPECT_LE(quantile(errors.depth, 0.5), 0.3);
  EXPECT_LE(quantile(errors.depth, 0.95), 1);
  // What the fit tells of itself is about right.
  EXPECT_NEAR(quantile(errors.depth, 0.5) / quantile(errors.told, 0.5), 0.7, 0.6);
}

TEST_P(TagResponse, TabletIsFoundToHundredthsOfAMillimetre) {
  TagCase what{tablet()};
  what.most_tilt = 50 * degree;
  what.response = what.assumed = GetParam();
  const TagErrors errors = tag_errors(what);
  EXPECT_EQ(errors.seen, what.places);
  EXPECT_LE(quantile(errors.depth, 0.5), 0.06);
  EXPECT_LE(quantile(errors.depth, 0.95), 0.2);
  EXPECT_LE(quantile(errors.turn, 0.5), 0.04 * degree);
}

INSTANTIATE_TEST_SUITE_P(Table, TagResponse, testing::Values(1.0, 2.2));

TEST(TagPose, TabletMostlyCoveredByAHandStaysFound) {
  TagCase what{tablet()};
  what.most_tilt = 40 * degree;
  what.covered = 0.7;
  const TagErrors errors = tag_errors(what);
  EXPECT_EQ(errors.seen, what.places);
  EXPECT_LE(quantile(errors.depth, 0.5), 0.32);
  EXPECT_LE(quantile(errors.depth, 0.95), 1.4);
}

TEST(TagPose, MotionBlurIsPutInTheMiddleOfTheExposure) {
  TagCase what{tablet()};
  what.most_tilt = 30 * degree;
  what.exposure = 0.01;
  what.speed = 0.3;  // 3 pixels
  const TagErrors errors = tag_errors(what);
  EXPECT_GE(errors.seen, what.places - 1);
  EXPECT_LE(quantile(errors.lateral, 0.5), 0.1);
  EXPECT_LE(quantile(errors.depth, 0.5), 0.3);
}

// What the quick search misses is read on once it was found.
TEST(TagPose, TabletIsReadOnFarAway) {
  TagCase what{tablet()};
  what.distance = 0.8;
  what.most_tilt = 40 * degree;
  what.reads_on = true;
  what.places = 6;
  const TagErrors errors = tag_errors(what);
  EXPECT_EQ(errors.seen, what.places);
  EXPECT_LE(quantile(errors.depth, 0.5), 0.5);
}

class TagLight : public testing::TestWithParam<double> {};

TEST_P(TagLight, ABoardInPoorLightIsFound) {
  for (const Board& board : {one_tag(), tablet()}) {
    TagCase what{board};
    what.distance = 0.6;
    what.most_tilt = 40 * degree;
    what.light = GetParam();
    what.places = 6;
    const TagErrors errors = tag_errors(what);
    EXPECT_EQ(errors.seen, what.places) << board.name;
    EXPECT_LE(quantile(errors.depth, 0.5), 0.5) << board.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Table, TagLight, testing::Values(0.3, 0.1, 0.06));

TEST(TagPose, LightTakenForBrightnessPutsATagTooFar) {
  TagCase what{one_tag()};
  what.response = 2.2;
  what.assumed = 1;
  EXPECT_GT(quantile(tag_errors(what).depth, 0.5), 2);
}

TEST(TagPose, ACodeThatIsThereTwiceIsLeftOut) {
  const Board board = tablet();
  SyntheticScene scene = usual_scene(usual_lens());
  Carrier left, right;
  left.pose.p = {-0.15, 0, -0.6};
  right.pose.p = {0.15, 0, -0.6};
  scene.add_board(board, left);
  scene.add_board(board, right);
  const Undistorter straightener(scene.lens);
  const auto tags = TagDetector({}).find(straightener.straight(grey_of(SceneRenderer(scene).paint(0))));
  EXPECT_EQ(tags.size(), 2 * board.tags.size());
  int twice = 0;
  EXPECT_TRUE(corners_seen(board, tags, &twice).empty());
  EXPECT_EQ(twice, 12) << "tags, each detected twice";
}

TEST(TagPose, SmallPicturesAreSearchedUndecimated) {
  const Board board = tablet();
  SyntheticScene scene = usual_scene(usual_lens().scaled(320, 240));
  Carrier held;
  held.pose.p = {0, 0, -0.6};
  scene.add_board(board, held);
  const Undistorter straightener(scene.lens);
  const auto tags = TagDetector({}).find(straightener.straight(grey_of(SceneRenderer(scene).paint(0))));
  EXPECT_EQ(tags.size(), board.tags.size());
}

TEST(TagPose, NothingIsFoundWhereNothingIs) {
  const Lens lens = usual_lens();
  const Undistorter straightener(lens);
  const TagDetector finder({});
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SyntheticScene scene = usual_scene(lens);
    scene.sensor.seed = seed;
    scene.sensor.noise = 40;
    EXPECT_TRUE(finder.find(straightener.straight(grey_of(SceneRenderer(scene).paint(seed)))).empty());
  }
  EXPECT_TRUE(finder.find({0, 0, {}}).empty());
  EXPECT_TRUE(finder.find({3, 3, std::vector<std::uint8_t>(9)}).empty());
  EXPECT_TRUE(solve_board({}, lens).empty());
}

}  // namespace
}  // namespace prosector
