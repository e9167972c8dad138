#include <gtest/gtest.h>

#include <random>

#include "common/error.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

SceneDesc busy() {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.03, 0, 0}, {0.02, 0.1, 0}),
                 part_body("a", "box", {0.05, 0.05, 0.05}, {0.3, 0.1, 0}),
                 part_body("b", "box", {0.05, 0.05, 0.05}, {0.31, 0.16, 0.01})};
  scene.soft = {block()};
  return scene;
}

TickInput input_at(int tick) {
  const Vec3 at(0.01, 0.12 - 0.001 * std::min(tick, 60), 0.045);
  TickInput input = tick == 0 ? appear(at) : target(at, Quat::Identity(), 0.01 * std::min(tick, 50));
  if (tick == 70) input = event(HandEvent::Kind::grasp, at);
  return input;
}

std::vector<std::uint64_t> hashes(Simulation& simulation, int from, int to, int checkpoint_at = -1) {
  std::vector<std::uint64_t> out;
  for (int i = from; i < to; ++i) {
    if (i == checkpoint_at) simulation.checkpoint();
    simulation.step(input_at(i));
    out.push_back(simulation.state_hash());
  }
  return out;
}

TEST(Determinism, SameInputsSameHashForAnyThreadCount) {
  Simulation one(busy(), options(1)), again(busy(), options(1)), two(busy(), options(2));
  EXPECT_EQ(one.content_hash(), two.content_hash());
  const auto expected = hashes(one, 0, 100);
  EXPECT_EQ(hashes(again, 0, 100), expected);
  EXPECT_EQ(hashes(two, 0, 100), expected);
}

TEST(Determinism, RestoredRunEqualsTheOneThatWentOn) {
  for (const int at : {30, 80}) {
    Simulation through(busy(), options());
    hashes(through, 0, at);
    const auto saved = through.checkpoint();
    Simulation restored(busy(), options());
    restored.restore(saved);
    EXPECT_EQ(restored.state_hash(), through.state_hash());
    EXPECT_EQ(hashes(restored, at, at + 40), hashes(through, at, at + 40)) << at;
  }
}

TEST(Determinism, BrokenCheckpointsAreRefusedAndChangeNothing) {
  Simulation simulation(busy(), options());
  hashes(simulation, 0, 75);
  const auto good = simulation.checkpoint();
  const std::uint64_t before = simulation.state_hash();
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 200)
    EXPECT_THROW(simulation.restore(std::span(good).first(size)), InputError);
  SceneDesc other = busy();
  other.rigid[1].material.density = 900;
  EXPECT_THROW(Simulation(other, options()).restore(good), InputError);
  EXPECT_EQ(simulation.state_hash(), before);
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    auto bad = good;
    for (int k = 0; k < 4; ++k) bad[random() % bad.size()] = static_cast<std::uint8_t>(random());
    try {
      simulation.restore(bad);
      simulation.step({});
    } catch (const InputError&) {
    }
  }
  simulation.restore(good);
  EXPECT_EQ(simulation.state_hash(), before);
}

}  // namespace
}  // namespace prosector::test
