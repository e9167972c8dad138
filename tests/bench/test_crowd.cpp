// Tests many hands on one organ: forces match a converged solve, and effort grows with the contacts.

#include <gtest/gtest.h>

#include "tests/bench/crowd.h"
#include "tests/physics/scenes.h"

namespace prosector {
namespace {

constexpr int settling = 45, watched = 15;   // ticks
constexpr double simulation_step = 1. / 60;  // s, as the scene has it
constexpr double depth = 0.012;              // m

/// Scene with a slab and a free box of equal height beside it; hands press both.
SceneDesc slab_and_box() {
  SceneDesc scene;
  scene.rigid = {test::table(), test::part_body("box", "box", {0.08, 0.06, 0.24}, {0.162, 0.03, 0})};
  SoftDesc slab = test::block("slab");
  slab.geometry.size = {0.24, 0.06, 0.24};
  slab.material.damping_mass = 4;
  slab.material.damping_stiffness = 0.02;
  scene.soft = {slab};
  return scene;
}

struct Pressed {
  std::vector<double> force;  // N, per hand, mean over the observed ticks
  double solver = 0;          // mean iterations per tick
};

Pressed press(const SceneDesc& scene, std::size_t users) {
  Simulation simulation(scene, test::options());
  const Crowd crowd(spread_places(simulation, pressed_body(simulation, ""), 2 * users, 1), users, 2, depth);
  const double h = 1 / scene.tick_rate;
  Pressed out;
  out.force.resize(crowd.hands());
  for (int tick = 0; tick < settling + watched; ++tick) {
    const StepReport& report = simulation.step(crowd.act(tick, h));
    if (tick < settling) continue;
    out.solver += static_cast<double>(report.bodies.front().solver_iterations) / watched;
    for (std::size_t hand = 0; hand < crowd.hands(); ++hand)
      out.force[hand] += simulation.hands()[hand].contact.impulse / h / watched;
  }
  return out;
}

TEST(Crowd, PressesAsHardAsSolvedToTheEnd) {
  SceneDesc scene = slab_and_box();
  const Pressed usual = press(scene, 4);
  scene.soft.front().configuration.newton_iterations = 40;
  scene.soft.front().configuration.solver_iterations = 2000;
  scene.soft.front().configuration.solver_tolerance = 1e-8;
  const Pressed exact = press(scene, 4);
  double sum = 0, off = 0;
  for (std::size_t hand = 0; hand < exact.force.size(); ++hand) {
    EXPECT_GT(exact.force[hand], 0.1) << hand;
    EXPECT_NEAR(usual.force[hand], exact.force[hand], 0.08 * exact.force[hand]) << hand;
    sum += exact.force[hand];
    off += usual.force[hand] - exact.force[hand];
  }
  EXPECT_NEAR(off, 0, 0.01 * sum);
}

TEST(Crowd, TakesLittleMoreIterationsThanOneUser) {
  EXPECT_LT(press(slab_and_box(), 8).solver, 3 * press(slab_and_box(), 1).solver);
}

TEST(Crowd, IsTheSameForAnyNumberOfThreads) {
  std::vector<std::uint64_t> hashes;
  for (const int threads : {1, 3}) {
    Simulation simulation(slab_and_box(), test::options(threads));
    const Crowd crowd(spread_places(simulation, pressed_body(simulation, ""), 32, 1), 16, 2, depth);
    for (int tick = 0; tick < settling; ++tick) simulation.step(crowd.act(tick, simulation_step));
    hashes.push_back(simulation.state_hash());
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

TEST(Crowd, PressesThePlacesThatTheSeedTells) {
  const Simulation simulation(slab_and_box(), test::options());
  const BodyId slab = pressed_body(simulation, "slab");
  const auto few = spread_places(simulation, slab, 3, 5), many = spread_places(simulation, slab, 9, 5);
  for (std::size_t k = 0; k < few.size(); ++k) EXPECT_EQ(few[k].at, many[k].at);
  for (std::size_t k = 0; k < many.size(); ++k)
    for (std::size_t j = 0; j < k; ++j) EXPECT_GT((many[k].at - many[j].at).norm(), 0.02);
  EXPECT_NE(spread_places(simulation, slab, 3, 6)[0].at, few[0].at);
}

}  // namespace
}  // namespace prosector
