// A short part of the play that deploy/play.sh goes on with for hours, of fixed seeds, and its judge.

#include <gtest/gtest.h>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "tests/folders.h"
#include "tests/play/play.h"
#include "tests/random.h"

namespace prosector::test {
namespace {

CompileOptions alone() {
  CompileOptions options;
  options.threads = 1;
  return options;
}

class ShippedScene : public testing::TestWithParam<const char*> {};

// With the shapes that scenes fall back to, which are the same everywhere.
TEST_P(ShippedScene, PeopleLeaveOrgansWholeAndApart) {
  Simulation simulation(load_scene(source_path("deploy/scenes/") + GetParam() + ".toml"), alone());
  const PlayFigures figures = play(simulation, {.seed = 20261123, .bout = 4, .rest = 3, .bounds = {}});
  EXPECT_GT(figures.acts, 0);
  EXPECT_EQ(figures.bouts, 1);
  for (const std::string& found : figures.found) ADD_FAILURE() << found;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedScene, testing::Values("touch", "cut"),
                         [](const auto& info) { return std::string(info.param); });

class AnyScene : public testing::TestWithParam<const char*> {};

// The server restores its own checkpoints while it runs: each state that play leads to must be restorable.
TEST_P(AnyScene, RestoresWhatItSavesAfterEveryTick) {
  const SceneDesc scene = load_scene(source_path("deploy/scenes/") + GetParam() + ".toml");
  Simulation simulation(scene, alone());
  SaveCheck saves(scene, alone());
  const PlayFigures figures =
      play(simulation, {.seed = test_seed(true), .bout = 0.8, .rest = 0.1, .bounds = {}, .saves = &saves});
  EXPECT_EQ(figures.bad_saves, 0) << (figures.found.empty() ? "" : figures.found.front());
}

INSTANTIATE_TEST_SUITE_P(Scenes, AnyScene,
                         testing::Values("touch", "abdomen", "cut", "sheet_cut", "contact", "curves", "cloth",
                                         "ropes", "minimal", "rigid"),
                         [](const auto& info) { return std::string(info.param); });

SceneDesc two_balls(double apart) {
  SceneDesc scene;
  for (const double side : {-0.5, 0.5}) {
    SoftDesc& ball = scene.soft.emplace_back();
    ball.name = side < 0 ? "left" : "right";
    ball.geometry.shape = "ball";
    ball.geometry.size = Vec3::Constant(0.1);
    ball.geometry.cell = ball.geometry.surface_cell = 0.025;
    ball.gravity = false;
    ball.pose.p.x() = side * apart;
  }
  return scene;
}

TEST(Judge, BlamesBodiesThatGotIntoEachOtherAndNotThoseThatTheScenePutThere) {
  Simulation apart(two_balls(0.15), alone());
  SceneDesc overlapping = two_balls(0.15);
  overlapping.soft[1].pose.p.x() = -0.075 + 0.09;
  for (SoftDesc& ball : overlapping.soft) ball.attach = {{ball.pose.p, 1, 1e12}};
  Simulation together(overlapping, alone());
  ASSERT_GT(overlap(together, 0, 1), 2e-3);
  EXPECT_TRUE(Judge(apart).look(apart).good());
  const Finding found = Judge(apart).look(together);
  EXPECT_FALSE(found.good());
  EXPECT_NE(found.where.find("left and right overlap"), std::string::npos) << found.where;
  EXPECT_TRUE(Judge(together).look(together).good());
}

TEST(Judge, BlamesAnOrganThatLostItsVolume) {
  SceneDesc hung = two_balls(0.3);
  for (SoftDesc& ball : hung.soft) {
    ball.gravity = true;
    ball.material.youngs_modulus = 300;
    ball.material.poisson_ratio = 0;
    ball.attach = {{ball.pose.p + Vec3(0, 10.04, 0), 10, 1e12}};
  }
  Simulation simulation(hung, alone());
  EXPECT_GT(volume_ratio(simulation, 0), 1.3) << "it hangs, drawn long";
  EXPECT_NE(Judge(simulation).look(simulation).where.find("of its volume"), std::string::npos);
}

}  // namespace
}  // namespace prosector::test
