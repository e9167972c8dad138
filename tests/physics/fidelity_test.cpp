// What a scene says about collision, in running sessions: fidelities and masks.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "server/physics/mechanics/rigid/collision_shape.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

double lowest(const Simulation& simulation, BodyId soft) {
  double y = 1e9;
  const VecX& x = simulation.soft_state(soft).motion.x;
  for (Eigen::Index i = 1; i < x.size(); i += 3) y = std::min(y, x[i]);
  return y;
}

/// A flat box, turned about y by 45°, 0.12 × 0.02 × 0.06 m.
SceneDesc plate(Fidelity collision) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("plate", "box", {0.12, 0.02, 0.06}, {0, 0.1, 0})};
  scene.rigid[1].pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()));
  scene.rigid[1].contact.collision = collision;
  return scene;
}

TEST(Fidelity, RigidBodyRestsOnWhatItCollidesAs) {
  const struct {
    Fidelity collision;
    double height;  // m, of its centre at rest
  } cases[] = {{Fidelity::mesh, 0.01},
               {Fidelity::hull, 0.01},
               {Fidelity::obb, 0.01},
               {Fidelity::aabb, 0.01},
               {Fidelity::sphere, std::sqrt(0.06 * 0.06 + 0.01 * 0.01 + 0.03 * 0.03)}};
  for (const auto& c : cases) {
    Simulation simulation(plate(c.collision), options());
    run(simulation, 120);
    EXPECT_NEAR(simulation.rigid_state(1).pose.p.y(), c.height, 1e-3) << fidelity_name(c.collision);
  }
  Simulation falls(plate(Fidelity::none), options());
  run(falls, 60);
  EXPECT_LT(falls.rigid_state(1).pose.p.y(), -3);
}

TEST(Fidelity, BoxesOfRigidBodiesAreThoseStated) {
  const collision::ShapePart box{collision::ShapeKind::box, {0.06, 0.01, 0.03}, {}, nullptr};
  const Pose turned{{1, 2, 3}, Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitY()))};
  const double wide = (0.06 + 0.03) / std::numbers::sqrt2;
  const collision::ShapePart room = rigid::at_fidelity({box}, Fidelity::aabb, turned).front();
  EXPECT_LT((room.half - Vec3(wide, 0.01, wide)).norm(), 1e-12);
  EXPECT_LT((turned * room.pose).q.angularDistance(Quat::Identity()), 1e-12);
  EXPECT_LT((turned * room.pose).p.cwiseAbs().maxCoeff() - 3, 1e-12);
  const collision::ShapePart own = rigid::at_fidelity({box}, Fidelity::obb, turned).front();
  EXPECT_NEAR(own.half.prod(), box.half.prod(), 1e-12);
}

/// The same on tissue: detection and response of soft bodies see the same shape.
TEST(Fidelity, TissueCarriesWhatTheRigidBodyCollidesAs) {
  for (const auto& [collision, reach] : {std::pair{Fidelity::hull, 0.01}, {Fidelity::sphere, 0.046}}) {
    SceneDesc scene;
    scene.rigid = {table(), part_body("plate", "box", {0.08, 0.02, 0.04}, {0, 0.12, 0}, 300)};
    scene.rigid[1].contact.collision = collision;
    scene.soft = {block()};
    Simulation simulation(scene, options());
    run(simulation, 60);
    double highest = 0;
    for (int i = 0; i < 120; ++i) {
      simulation.step({});
      highest = std::max(highest, simulation.rigid_state(1).pose.p.y());
    }
    EXPECT_LT(highest, 0.06 + reach + 2e-3) << fidelity_name(collision);
    EXPECT_GT(highest, 0.06 + reach - 1.2e-2) << fidelity_name(collision);
  }
}

TEST(Masks, DecideWhoPassesThroughWhom) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ghost", "sphere", {0.04, 0, 0}, {0, 0.1, 0}),
                 part_body("solid", "sphere", {0.04, 0, 0}, {0.3, 0.1, 0})};
  scene.soft = {block(), block("wraith")};
  for (SoftDesc& soft : scene.soft) soft.pose.p.y() += 0.05;
  scene.soft[1].pose.p.x() = -0.3;
  scene.rigid[0].contact.group = "room";
  scene.rigid[1].contact.group = scene.soft[1].contact.group = "ghosts";
  scene.rigid[1].contact.touches = {hand_group};
  scene.soft[1].contact.touches = {"ghosts"};
  Simulation simulation(scene, options());
  run(simulation, 90);
  EXPECT_LT(simulation.rigid_state(1).pose.p.y(), -1) << "touches only hands";
  EXPECT_NEAR(simulation.rigid_state(2).pose.p.y(), 0.02, 1e-3);
  EXPECT_GT(lowest(simulation, 3), -1e-3);
  EXPECT_LT(lowest(simulation, 4), -1) << "the table is in another group";
}

TEST(Masks, OfSoftBodiesAtNoFidelity) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {block()};
  scene.soft[0].contact.collision = Fidelity::none;
  Simulation simulation(scene, options());
  run(simulation, 60);
  EXPECT_LT(lowest(simulation, 1), -1);
}

// A thin probe or a small ball at 50 m/s: 0.83 m a tick, through a slab of 3 cm.
TEST(Continuous, FastProbeIsStoppedByTissue) {
  for (const bool on : {false, true}) {
    SceneDesc scene;
    scene.gravity = {0, -600, 0};  // 50 m/s after 5 ticks and 2.5 m
    scene.soft = {block()};
    scene.soft[0].gravity = false;
    scene.soft[0].geometry.size = {0.1, 0.03, 0.1};
    scene.soft[0].attach = {{.center = {0, 0.03, 0}, .radius = 0.2, .stiffness = 1e11}};
    scene.rigid = {part_body("probe", "capsule", {0.006, 0.06, 0}, {0.003, 2.9, 0.002})};
    scene.rigid[0].material.mass = 1e-4;
    scene.rigid[0].contact.continuous = on;
    Simulation simulation(scene, options());
    bool touched = false;
    double lowest = 1;
    for (int tick = 0; tick < 9; ++tick) {
      const StepReport& report = simulation.step({});
      touched = touched || report.contacts > 0;
      lowest = std::min(lowest, simulation.rigid_state(0).pose.p.y());
    }
    EXPECT_EQ(touched, on);
    EXPECT_EQ(lowest > 0, on) << lowest;
  }
}

TEST(Continuous, FastTissueIsStoppedByAPlate) {
  for (const bool on : {false, true}) {
    SceneDesc scene;
    scene.gravity = {0, -600, 0};
    scene.rigid = {part_body("plate", "box", {1, 0.005, 1}, {0, 0, 0})};
    scene.rigid[0].fixed = true;
    scene.soft = {block()};
    scene.soft[0].material.youngs_modulus = 1e6;
    scene.soft[0].pose.p.y() = 2.9;
    scene.soft[0].contact.continuous = on;
    Simulation simulation(scene, options());
    run(simulation, 12);
    EXPECT_EQ(lowest(simulation, 1) > -0.03, on) << lowest(simulation, 1);
  }
}

}  // namespace
}  // namespace prosector::test
