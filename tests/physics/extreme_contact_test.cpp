// What no input may break, in small: things poured on tissue, plates that close, a probe as fast as a bullet
// train, a hand that leaps. Finite, bounded, back in shape, and what was lost is reported.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double back = 1e-3;  // m: the shape is back
const Vec3 size(0.1, 0.06, 0.1);

/// Coarse tissue on a table without friction, which could hold a strain, tied by the middle of its base.
SceneDesc tied_block() {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.rigid[0].contact.friction = 0;
  scene.soft = {block()};
  scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.025;
  scene.soft[0].attach = {{{0, 0, 0}, 0.015, 2e7}};
  return scene;
}

/// Steps, and watches one soft body.
struct Watched {
  Simulation simulation;
  BodyId body;
  double widest = 0;  // m: of a node from the body's middle
  bool finite = true;
  int resets = 0;

  Watched(const SceneDesc& scene)
      : simulation(scene, options()), body(static_cast<BodyId>(scene.rigid.size())) {}
  void step(const TickInput& input = {}) {
    for (const BodyReport& row : simulation.step(input).bodies) resets += row.reset;
    const VecX& x = simulation.soft_state(body).motion.x;
    finite = finite && x.allFinite();
    const auto nodes = x.reshaped(3, x.size() / 3);
    widest = std::max(
        widest, std::sqrt((nodes.colwise() - nodes.rowwise().mean()).colwise().squaredNorm().maxCoeff()));
  }
  void drive(BodyId what, const Pose& to) {
    TickInput input;
    input.kinematic_targets.push_back({what, to});
    step(input);
  }
  void expect_back() {
    EXPECT_TRUE(finite);
    EXPECT_EQ(resets, 0);
    EXPECT_LT(widest, 2 * size.norm() / 2);
    for (int i = 0; i < 300 && !simulation.asleep(body); ++i) step();
    EXPECT_LT(simulation.max_displacement(body), back);
  }
};

TEST(ExtremeContact, SqueezedFlatAtAnySpeedTissueIsBack) {
  for (const double speed : {0.05, 0.5, 5.0}) {
    SceneDesc scene = tied_block();
    scene.rigid.push_back(part_body("press", "box", {0.4, 0.02, 0.4}, {0, 0.075, 0}));
    scene.rigid[1].fixed = true;
    scene.rigid[1].contact.friction = 0;
    Watched run(scene);
    constexpr double open = 0.075, shut = 0.016;
    const auto plate_at = [&](double y) { run.drive(1, {{0, y, 0}, Quat::Identity()}); };
    const double way = speed / scene.tick_rate;
    for (double y = open; y > shut;) plate_at(y = std::max(shut, y - way));
    for (int i = 0; i < 12; ++i) plate_at(shut);
    // Tissue is between the plates, not around the upper one, which at 5 m/s closes within a tick.
    const auto heights = run.simulation.soft_state(2).motion.x(Eigen::seq(1, Eigen::last, Eigen::fix<3>));
    EXPECT_LT(heights.maxCoeff() - heights.minCoeff(), 0.016) << speed;
    for (double y = shut; y < open;) plate_at(y = std::min(open, y + way));
    SCOPED_TRACE(speed);
    run.expect_back();
  }
}

TEST(ExtremeContact, AProbeGoesThroughAt50MetresASecond) {
  for (const double tick_rate : {60.0, 1000.0}) {
    SceneDesc scene = tied_block();
    scene.tick_rate = tick_rate;
    scene.soft[0].attach[0].radius = 0.04;
    scene.rigid.push_back(part_body("probe", "capsule", {0.012, 0.2, 0}, {-1, 0.03, 0.005}));
    scene.rigid[1].fixed = true;
    const Quat along(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
    scene.rigid[1].pose.q = along;
    Watched run(scene);
    for (double x = -1; x < 1;) run.drive(1, {{x += 50 / tick_rate, 0.03, 0.005}, along});
    for (int i = 0; i < 2 * tick_rate; ++i) run.step();
    SCOPED_TRACE(tick_rate);
    run.expect_back();
  }
}

TEST(ExtremeContact, AHandLeapsByAMetreEachTick) {
  for (const bool holding : {false, true}) {
    SceneDesc scene = tied_block();
    scene.soft[0].attach[0].radius = 0.04;
    Watched run(scene);
    const Vec3 on_top(-0.004, 0.073, 0.045);
    run.step(appear(on_top));
    if (holding) {
      run.step(event(HandEvent::Kind::grasp, on_top));
      ASSERT_TRUE(run.simulation.hands()[0].holding);
    }
    double farthest = 0;
    for (int i = 0; i < 60; ++i) {
      run.step(target(on_top + (i % 2 == 0 ? 0.5 : -0.5) * Vec3(1, holding ? 1 : 0, 0)));
      farthest = std::max(farthest, run.simulation.hands()[0].pose.p.norm());
    }
    EXPECT_LT(farthest, 1);
    run.step(event(HandEvent::Kind::vanish, on_top));
    SCOPED_TRACE(holding);
    run.expect_back();
  }
}

TEST(ExtremeContact, PouredBoxesPileUpOrRollOff) {
  constexpr int boxes = 12;
  constexpr double box = 0.02;
  SceneDesc scene = tied_block();
  scene.rigid[0].contact.friction = 0.5;
  for (int i = 0; i < boxes; ++i) {
    const Vec3 at(0.036 * (i % 2 - 0.5), 0.09 + 0.04 * (i / 4), 0.036 * (i / 2 % 2 - 0.5));
    scene.rigid.push_back(part_body("box " + std::to_string(i), "box", Vec3::Constant(box), at));
    scene.rigid.back().pose.q = Quat(Eigen::AngleAxisd(0.4 * i, Vec3(0.2, 1, 0.3).normalized()));
  }
  Watched run(scene);
  double fastest = 0;
  for (int tick = 0; tick < 240; ++tick) {
    run.step();
    for (BodyId b = 1; b <= boxes; ++b) {
      const RigidBodyState box_state = run.simulation.rigid_state(b);
      ASSERT_TRUE(is_finite(box_state.pose)) << tick;
      fastest = std::max(fastest, box_state.linear_velocity.norm());
    }
  }
  EXPECT_TRUE(run.finite);
  EXPECT_EQ(run.resets, 0);
  EXPECT_LT(fastest, 1.1 * std::sqrt(2 * 9.81 * 0.18)) << "no faster than a fall to the table";
  EXPECT_LT(run.widest, 1.2 * size.norm() / 2);
  for (BodyId b = 1; b <= boxes; ++b) {
    const Vec3 at = run.simulation.rigid_state(b).pose.p;
    EXPECT_GT(at.y(), box / 2 - 2e-3) << "through the table: box " << b;
    EXPECT_LT(at.norm(), 2);
  }
}

}  // namespace
}  // namespace prosector::test
