// What people did to organs, and what organs made of it: shapes that they must come back from.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "tests/folders.h"
#include "tests/physics/scenes.h"
#include "tests/play/judge.h"

namespace prosector::test {
namespace {

/// A tied bar that hangs, and a small ball that lands on it.
SceneDesc hanging_bar() {
  SceneDesc scene;
  scene.name = "hang";
  scene.rigid = {part_body("ball", "sphere", {0.01, 0.01, 0.01}, {-0.045, 0.05, 0})};
  SoftDesc& bar = scene.soft.emplace_back();
  bar.name = "bar";
  bar.geometry.shape = "beam";
  bar.geometry.size = {0.12, 0.04, 0.04};
  bar.configuration.element = "tet10";
  bar.attach = {{{-10.055, 0, 0}, 10, 1e12}};
  return scene;
}

CompileOptions plain() {
  CompileOptions options;
  options.threads = 1;
  return options;
}

TEST(Collapse, TouchedBarHangsAgainWhereItHungUnderItsOwnLaw) {
  Simulation simulation(hanging_bar(), plain());
  const VecX hung = simulation.soft_state(1).motion.x;
  ASSERT_LT(simulation.soft(1).rest()[1] - 0.02, 1);
  const double sunk = (hung - simulation.soft(1).rest()).lpNorm<Eigen::Infinity>();
  ASSERT_GT(sunk, 0.03) << "it hangs";
  run(simulation, 1200);
  EXPECT_FALSE(simulation.soft_state(1).recovering);
  EXPECT_LT((simulation.soft_state(1).motion.x - hung).lpNorm<Eigen::Infinity>(), 0.02 * sunk);
}

/// The hand of a mouse at a desk: thrown into the kidney from above, then through kidney and liver.
TEST(Collapse, OrgansThatAHandSweptIntoEachOtherComeApart) {
  SceneDesc scene = load_scene(source_path("deploy/scenes/touch.toml"));
  CompileOptions compiled;
  compiled.threads = 1;
  compiled.data_dirs = {default_data_dir()};
  Simulation simulation(scene, compiled);
  const Judge judge(simulation);
  const Quat turned(0.94299303515446342, -0.24078565588303089, -0.22261045644208774, -0.05684178264091478);
  const auto hold = [&](const Vec3& at, int ticks) { run(simulation, ticks, target(at, turned, 0.1)); };
  run(simulation, 1, appear({0.25088226795196533, 1.4097791910171509, 0.06940777599811554}, turned));
  hold({0.25088226795196533, 1.4097791910171509, 0.06940777599811554}, 10);
  hold({0.059637568891048431, 0.95025956630706787, 0.14710028469562531}, 122);
  hold({-0.18559081852436066, 1.0115559101104736, -0.0185711570084095}, 2);
  simulation.checkpoint();  // as the session did
  hold({-0.18559081852436066, 1.0115559101104736, -0.0185711570084095}, 240);
  TickInput gone;
  gone.events.push_back({HandEvent::Kind::vanish, somebody, right_hand});
  run(simulation, 1, gone);
  run(simulation, 300);
  const Finding found = judge.look(simulation);
  EXPECT_TRUE(found.good()) << found.where;
  EXPECT_EQ(found.inverted, 0);
  EXPECT_LT(found.overlap, 2e-3);
}

/// A cube that bears nearly what buckles it.
class HeavyCube : public testing::TestWithParam<double> {};

TEST_P(HeavyCube, StandsOnItsFootAndStaysThereWhenTouched) {
  SceneDesc scene;
  scene.gravity = {0, -2 * 9.81, 0};
  scene.rigid = {table()};
  SoftDesc& cube = scene.soft.emplace_back();
  cube.name = "cube";
  cube.geometry.shape = "block";
  cube.geometry.size = {0.1, 0.1, 0.1};
  cube.pose.p = {0, 0.05, 0};
  cube.material.youngs_modulus = 5000;
  cube.material.poisson_ratio = GetParam();
  Simulation simulation(scene, plain());
  const auto expect_sound = [&](const char* when) {
    const VecX& x = simulation.soft_state(1).motion.x;
    EXPECT_GT(volume_ratio(simulation, 1), 0.7) << when;
    EXPECT_LT(volume_ratio(simulation, 1), 1.3) << when;
    EXPECT_EQ(soft::inverted_share(simulation.soft(1).linear_tets(), x), 0) << when;
    // Of the surface, which touches the table and is drawn; nodes at the corners are outside of it.
    double lowest = 1;
    const Anatomy& anatomy = simulation.soft(1).anatomy();
    for (std::size_t i = 0; i < anatomy.surface.positions.size(); ++i)
      lowest = std::min(lowest, anatomy.embedding.apply(i, x.data()).y());
    EXPECT_GT(lowest, -2e-3) << when << ": it is in the table";
  };
  expect_sound("compiled");
  run(simulation, 1, appear({0, 0.3, 0.1}));
  run(simulation, 60, target({0, 0.12, 0.1}));
  TickInput gone;
  gone.events.push_back({HandEvent::Kind::vanish, somebody, right_hand});
  run(simulation, 1, gone);
  run(simulation, 300);
  expect_sound("5 s after a hand left it");
}

INSTANTIATE_TEST_SUITE_P(PoissonRatios, HeavyCube, testing::Values(0.3, 0.45, 0.49));

}  // namespace
}  // namespace prosector::test
