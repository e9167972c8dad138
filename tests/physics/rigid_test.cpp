#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/error.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

TEST(Rigid, FallsAndComesToRestOnTheTable) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("box", "box", {0.1, 0.1, 0.1}, {0, 0.25, 0})};
  Simulation simulation(scene, options());
  run(simulation, 6);
  EXPECT_NEAR(simulation.rigid_state(1).linear_velocity.y(), -0.981, 0.01);
  run(simulation, 400);
  EXPECT_NEAR(simulation.rigid_state(1).pose.p.y(), 0.05, 5e-4);
  EXPECT_TRUE(simulation.asleep(1));
}

TEST(Rigid, HeavyBoxesStandOnLightOnes) {
  for (const double ratio : {3.0, 10.0, 100.0, 1e3, 1e5}) {  // smaller ones are left to Bullet
    SceneDesc scene;
    scene.rigid = {table(), part_body("light", "box", {0.1, 0.1, 0.1}, {0, 0.051, 0}),
                   part_body("heavy", "box", {0.1, 0.1, 0.1}, {0, 0.152, 0})};
    scene.rigid[1].material.mass = 1;
    scene.rigid[2].material.mass = ratio;
    Simulation simulation(scene, options());
    run(simulation, 600);
    for (const BodyId body : {1, 2}) {
      const Vec3 at = simulation.rigid_state(body).pose.p;
      EXPECT_NEAR(at.y(), 0.1 * body - 0.05, 1e-3) << ratio;
      EXPECT_LT(std::hypot(at.x(), at.z()), 3e-3) << ratio;
      EXPECT_TRUE(simulation.asleep(body)) << ratio;
    }
  }
}

TEST(Rigid, InclineSlidesBeyondTheFrictionAngleOnly) {
  for (const double degrees : {10.0, 30.0}) {
    SceneDesc scene;
    const double angle = degrees * std::numbers::pi / 180;
    scene.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
    scene.rigid = {table(), part_body("box", "box", {0.1, 0.05, 0.1}, {-0.5, 0.0251, 0})};
    scene.rigid[0].contact.friction = 0.6;
    scene.rigid[1].contact.friction = 0.5;  // Bullet takes the product: 0.3
    Simulation simulation(scene, options());
    run(simulation, 30);
    const double from = simulation.rigid_state(1).pose.p.x();
    const double speed = simulation.rigid_state(1).linear_velocity.x();
    run(simulation, 15);
    const double moved = simulation.rigid_state(1).pose.p.x() - from;
    const double expected = degrees < 16 ? 0 : 9.81 * (std::sin(angle) - 0.3 * std::cos(angle));
    EXPECT_NEAR((simulation.rigid_state(1).linear_velocity.x() - speed) / 0.25, expected, 0.15) << degrees;
    EXPECT_EQ(moved > 1e-3, degrees > 16) << degrees;
  }
}

TEST(Rigid, MassesFollowClosedForms) {
  struct Case {
    const char* shape;
    Vec3 size;
    double volume;
  };
  for (const Case& c :
       {Case{"box", {0.1, 0.2, 0.3}, 0.006}, Case{"sphere", {0.2, 0, 0}, std::numbers::pi * 0.008 / 6},
        Case{"ellipsoid", {0.1, 0.2, 0.3}, std::numbers::pi * 0.006 / 6},
        Case{"cylinder", {0.1, 0.2, 0.1}, std::numbers::pi * 0.0005},
        Case{"capsule", {0.1, 0.2, 0.1}, std::numbers::pi * (0.0025 * 0.1 + 0.001 / 6)}}) {
    SceneDesc scene;
    scene.rigid = {part_body("thing", c.shape, c.size, {0, 10, 0})};
    Simulation simulation(scene, options());
    const StepReport& report = simulation.step({});
    const double v = 9.81 / 60;
    EXPECT_NEAR(report.kinetic_energy, 1000 * c.volume * v * v / 2, 1e-4 * 1000 * c.volume * v * v)
        << c.shape;
  }
}

TEST(Rigid, TwoHundredBoxesStayFinite) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.rigid[0].geometry.parts[0].size = {20, 0.1, 20};  // some roll far
  for (int i = 0; i < 200; ++i)
    scene.rigid.push_back(part_body("box" + std::to_string(i), "box", {0.05, 0.05, 0.05},
                                    {0.06 * (i % 5), 0.03 + 0.06 * (i / 25), 0.06 * (i / 5 % 5)}));
  Simulation simulation(scene, options());
  run(simulation, 120);
  for (BodyId i = 1; i < simulation.body_count(); ++i) {
    EXPECT_TRUE(is_finite(simulation.rigid_state(i).pose));
    EXPECT_GT(simulation.rigid_state(i).pose.p.y(), 0.015)
        << i << " at " << simulation.rigid_state(i).pose.p.transpose();
  }
}

TEST(Rigid, BodyWithoutVolumeIsRefused) {
  SceneDesc scene;
  scene.rigid = {part_body("nothing", "box", {0.1, 0.1, 0}, {0, 0, 0})};
  EXPECT_THROW(Simulation(scene, options()), InputError);
}

}  // namespace
}  // namespace prosector::test
