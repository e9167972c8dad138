// Estimates of a running simulation: they tell, and change nothing.

#include "server/accuracy/live_estimates.h"

#include <gtest/gtest.h>

#include "tests/physics/scenes.h"

namespace prosector {
namespace {

SceneDesc pressed_scene() {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.soft = {test::block("one"), test::block("two")};
  scene.soft[1].pose.p.x() = 0.3;
  for (SoftDesc& soft : scene.soft) soft.attach.push_back({{soft.pose.p.x(), -1e4, 0}, 1e4 + 1e-3, 1e12});
  return scene;
}

/// A hand comes down on the first block, and leaves again after two seconds.
TickInput input_at(int tick) {
  const int down = std::min(tick, 60) - std::max(0, std::min(tick - 120, 60));
  const Vec3 at(0.01, 0.14 - 0.001 * down, 0.045);
  return tick == 0 ? test::appear(at) : test::target(at);
}

TEST(LiveEstimates, ChangeNoHashAndAreTheSameForAnyThreads) {
  Simulation alone(pressed_scene(), test::options(1)), watched(pressed_scene(), test::options(2)),
      again(pressed_scene(), test::options(1));
  LiveEstimates estimates(watched), others(again);
  bool pressed = false;
  for (int tick = 0; tick < 200; ++tick) {
    alone.step(input_at(tick));
    estimates.follow(watched, watched.step(input_at(tick)));
    others.follow(again, again.step(input_at(tick)));
    ASSERT_EQ(watched.state_hash(), alone.state_hash()) << tick;
    const LiveEstimate *one = estimates.newest(1), *other = others.newest(1);
    ASSERT_EQ(one == nullptr, other == nullptr);
    if (one == nullptr) continue;
    EXPECT_EQ(one->error, other->error) << "to the bit";
    EXPECT_EQ(one->map.levels, other->map.levels);
    pressed = pressed || one->press_error >= 0;
  }
  EXPECT_TRUE(pressed) << "a hand was on it";
}

TEST(LiveEstimates, TellOfEveryBodyWithinASecondAndOfAPressWhileItLasts) {
  Simulation simulation(pressed_scene(), test::options());
  LiveEstimates estimates(simulation);
  for (int tick = 0; tick < 60; ++tick) estimates.follow(simulation, simulation.step({}));
  for (const BodyId body : {1u, 2u}) {
    ASSERT_NE(estimates.newest(body), nullptr) << body;
    EXPECT_GT(estimates.newest(body)->error, 0) << "linear tetrahedra under their weight";
    EXPECT_LT(estimates.newest(body)->error, 1);
    EXPECT_LT(estimates.newest(body)->press_error, 0) << "nobody presses";
    EXPECT_EQ(estimates.newest(body)->parts.time, 0) << "at rest";
    EXPECT_FALSE(estimates.newest(body)->map.levels.empty());
  }
  EXPECT_EQ(estimates.newest(0), nullptr) << "the table is rigid";
  for (int tick = 0; tick < 100; ++tick) estimates.follow(simulation, simulation.step(input_at(tick)));
  EXPECT_GT(estimates.newest(1)->press_error, 0);
  EXPECT_GT(estimates.newest(1)->press_force, 0);
  EXPECT_LT(estimates.newest(2)->press_error, 0);
  for (int tick = 120; tick < 400; ++tick) estimates.follow(simulation, simulation.step(input_at(tick)));
  EXPECT_LT(estimates.newest(1)->press_error, 0) << "the hand left";
}

/// A fraction of next to nothing would be told as if something were wrong.
TEST(LiveEstimates, TellNoErrorOfWhatMovesByLessThanIsSeen) {
  for (const double weight : {1e-3, 1.}) {
    SceneDesc scene = pressed_scene();
    scene.gravity *= weight;
    Simulation simulation(scene, test::options());
    LiveEstimates estimates(simulation);
    for (int tick = 0; tick < 60; ++tick) estimates.follow(simulation, simulation.step({}));
    ASSERT_NE(estimates.newest(1), nullptr);
    EXPECT_EQ(estimates.newest(1)->error > 0, weight == 1) << weight;
    EXPECT_EQ(std::abs(estimates.newest(1)->parts.discretisation) > 0, weight == 1) << weight;
  }
}

/// As of sessions that go on with a restored state: nothing is known yet of how fast nodes were.
TEST(LiveEstimates, BeginWithBodiesThatMove) {
  Simulation simulation(pressed_scene(), test::options());
  for (int tick = 0; tick < 75; ++tick) simulation.step(input_at(tick));
  ASSERT_FALSE(simulation.asleep(1));
  LiveEstimates estimates(simulation);
  for (int tick = 75; tick < 135; ++tick) estimates.follow(simulation, simulation.step(input_at(tick)));
  ASSERT_NE(estimates.newest(1), nullptr);
  EXPECT_GT(estimates.newest(1)->press_error, 0);
}

/// What no law tells the stress of isn't judged.
TEST(LiveEstimates, SayNothingOfSpringsAndRopes) {
  SceneDesc scene = pressed_scene();
  scene.soft[0].configuration.model = "mass_spring";
  Simulation simulation(scene, test::options());
  LiveEstimates estimates(simulation);
  for (int tick = 0; tick < 60; ++tick) estimates.follow(simulation, simulation.step({}));
  EXPECT_EQ(estimates.newest(1), nullptr);
  EXPECT_NE(estimates.newest(2), nullptr);
}

}  // namespace
}  // namespace prosector
