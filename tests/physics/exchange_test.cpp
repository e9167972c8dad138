// What rigid and soft bodies give each other: momentum, energy, weight, friction.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "server/physics/mechanics/coupled/island_system.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double block_mass = 0.6;

Vec3 momentum(const soft::SoftBody& body, const soft::SoftBodyState& state) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    sum += body.node_mass()[i] * state.motion.v.segment<3>(3 * i);
  return sum;
}

Vec3 centre(const Simulation& simulation, BodyId soft) {
  const auto nodes = simulation.soft_state(soft).motion.x.reshaped(3, simulation.soft(soft).nodes());
  return nodes.rowwise().mean();
}

TEST(Exchange, BounceKeepsMomentumAndGainsNoEnergy) {
  SceneDesc scene;
  scene.gravity = {0, -1, 0};  // takes the ball to the block, which has none
  scene.soft = {block()};
  scene.soft[0].gravity = false;
  scene.soft[0].material.damping_mass = 0;
  scene.soft[0].configuration.newton_iterations = 30;
  scene.soft[0].configuration.solver_iterations = 400;
  scene.soft[0].configuration.solver_tolerance = 1e-8;
  scene.rigid = {part_body("ball", "sphere", {0.04, 0, 0}, {0.015, 0.5, 0}, 3000)};
  Simulation simulation(scene, options());
  const double ball_mass = 3000 * 4.0 / 3 * std::numbers::pi * 8e-6;
  const double start = ball_mass * 0.5, fallen = ball_mass * 0.42;
  double highest = 0;
  for (int tick = 1; tick <= 90; ++tick) {
    const StepReport& report = simulation.step({});
    const double energy = report.kinetic_energy + report.elastic_energy + report.potential_energy;
    highest = std::max(highest, energy - start);
    const Vec3 of_block = momentum(simulation.soft(1), simulation.soft_state(1));
    const Vec3 of_ball = ball_mass * simulation.rigid_state(0).linear_velocity;
    const Vec3 lost = of_block + of_ball - ball_mass * tick / 60.0 * scene.gravity;
    EXPECT_LT(lost.norm(), 1e-3 * std::max(of_block.norm(), 0.01)) << tick;
  }
  EXPECT_FALSE(simulation.asleep(1));
  EXPECT_GT(momentum(simulation.soft(1), simulation.soft_state(1)).norm(), 0.03);
  EXPECT_LT(highest, 1e-3 * fallen);
}

// A plate that goes 6 cm within a tick is taken along it in parts: what it gave in all of them is told.
TEST(Exchange, AFastPlatesImpulseIsWhatTheTissueGot) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.soft = {block()};
  scene.soft[0].material.damping_mass = 0;
  scene.soft[0].configuration.newton_iterations = 30;
  scene.soft[0].configuration.solver_iterations = 400;
  scene.soft[0].configuration.solver_tolerance = 1e-8;
  scene.rigid = {part_body("plate", "box", {0.4, 0.02, 0.4}, {0, 0.1, 0})};
  scene.rigid[0].fixed = true;
  Simulation simulation(scene, options());
  Vec3 given = Vec3::Zero();
  for (const double y : {0.04, 0.04, 0.04}) {
    TickInput input;
    input.kinematic_targets.push_back({0, {{0, y, 0}, Quat::Identity()}});
    simulation.step(input);
    for (const Exchange& touch : simulation.exchanges()) given += (touch.b == 0 ? 1 : -1) * touch.impulse;
    const Vec3 got = momentum(simulation.soft(1), simulation.soft_state(1));
    EXPECT_LT((given - got).norm(), 1e-3 * got.norm());
  }
  EXPECT_LT(given.y(), -0.6);  // at 1 m/s or more
  EXPECT_EQ(simulation.time().tick, 3U);
}

// A line search may take a small part of a step that all but keeps the balance, near rest in ticks of their
// own.
TEST(Exchange, AShortenedStepTellsTheWholeForce) {
  constexpr double h = 1.0 / 60;
  soft::SoftBody body(block(), make_block({0.1, 0.1, 0.1}, {2, 2, 2}));
  soft::SoftBodyState state = body.initial_state();
  const auto exchanged = [&](double length, bool balanced, bool all_held) {
    coupled::Island island;
    island.soft.push_back({0, &body, &state});
    contact::Contact& pressed = island.contacts.emplace_back();
    pressed.a.kind = contact::ContactSide::Kind::soft;
    pressed.a.add(body.anatomy().embedding.rows[0], 1);
    pressed.normal = Vec3::UnitY();
    pressed.gap = -1e-3;
    pressed.stiffness = 1e3;
    body.stepper().begin_stage(0, h, {}, state, true);
    coupled::IslandSystem system;
    system.begin(island, h);
    VecX q, g;
    system.initial_guess(q);
    system.linearise(q);
    system.joints().lag_friction(q);
    system.gradient(q, g);
    system.assemble(q, false);
    if (balanced) system.joints().take_balanced();
    system.joints().take(length, VecX::Zero(q.size()));
    system.joints().write_joint_forces(q, all_held);
    return pressed.exchanged.y();
  };
  for (const double length : {1.0, 0.5, 1.0 / 32}) {
    EXPECT_NEAR(std::abs(exchanged(length, false, true)), 1, 1e-12) << length;  // N: 1 kN/m, 1 mm
    EXPECT_NEAR(std::abs(exchanged(length, true, false)), 1, 1e-12) << length;
    EXPECT_NEAR(std::abs(exchanged(length, false, false)), length, 1e-12)
        << length;  // what it moved free bodies by
  }
}

/// How deep the block's deepest node is in the plate, m.
double sunk(const Simulation& simulation, BodyId plate, BodyId soft) {
  const Pose to_plate = simulation.rigid_state(plate).pose.inverse();
  const VecX& nodes = simulation.soft_state(soft).motion.x;
  double deepest = -1;
  for (Eigen::Index i = 0; i < nodes.size(); i += 3) {
    const Vec3 x = to_plate * Vec3(nodes.segment<3>(i));
    if (std::abs(x.x()) < 0.07 && std::abs(x.z()) < 0.07) deepest = std::max(deepest, x.y() + 0.01);
  }
  return deepest;
}

// The tolerance that a scene states: contact yields as the tissue would over a surface cell, made
// contact_stiffness times stiffer.
TEST(Exchange, RigidPlateRestsOnTissueAtAnyMassRatio) {
  for (const double ratio : {1e-4, 1.0, 1e4}) {
    SceneDesc scene;
    scene.rigid = {table(), part_body("plate", "box", {0.14, 0.02, 0.14}, {0, 0.0701, 0})};
    scene.rigid[1].material.mass = ratio * block_mass;
    scene.soft = {block()};
    if (ratio > 1) scene.soft[0].material.youngs_modulus = 1e8;  // or it would be flat
    Simulation simulation(scene, options());
    run(simulation, 300);
    const Vec3 before = simulation.rigid_state(1).pose.p;
    double speed = 0;
    for (int i = 0; i < 60; ++i) {
      simulation.step({});
      speed = std::max(speed, simulation.rigid_state(1).linear_velocity.norm());
    }
    const double pressure = scene.rigid[1].material.mass * 9.81 / 0.01;
    const double yields = pressure / scene.soft[0].material.youngs_modulus *
                          scene.soft[0].geometry.surface_cell / scene.contact_stiffness;
    EXPECT_LT(speed, 1e-3) << ratio;
    EXPECT_LT((simulation.rigid_state(1).pose.p - before).norm(), 1e-5) << ratio;
    EXPECT_LT(sunk(simulation, 1, 2), 3 * yields + 1e-5) << ratio;  // edges carry more than the middle
  }
}

TEST(Exchange, TissueRestsOnARigidPlateAtAnyMassRatio) {
  for (const double ratio : {1e-4, 1.0, 1e4}) {
    SceneDesc scene;
    scene.rigid = {table(), part_body("plate", "box", {0.14, 0.02, 0.14}, {0, 0.0101, 0})};
    scene.rigid[1].material.mass = ratio * block_mass;
    scene.soft = {block()};
    scene.soft[0].pose.p.y() = 0.0503;
    Simulation simulation(scene, options());
    run(simulation, 300);
    const Vec3 before = simulation.rigid_state(1).pose.p, block_before = centre(simulation, 2);
    run(simulation, 60);
    EXPECT_LT((simulation.rigid_state(1).pose.p - before).norm(), 1e-5) << ratio;
    EXPECT_LT((centre(simulation, 2) - block_before).norm(), 1e-4) << ratio;
    EXPECT_NEAR(simulation.rigid_state(1).pose.p.y(), 0.01, 5e-4) << ratio;
    EXPECT_NEAR(centre(simulation, 2).y(), 0.048, 2e-3) << ratio;
  }
}

TEST(Exchange, BlockOnAnInclineSticksBelowTheFrictionAngleAndSlidesAbove) {
  for (const double beyond : {-1.0, 1.0}) {
    SceneDesc scene;
    scene.soft = {block()};
    scene.soft[0].material.youngs_modulus = 2e5;
    scene.rigid = {table(), part_body("waker", "sphere", {0.01, 0, 0}, {0, 0.08, 0}, 100)};
    scene.rigid[0].geometry.parts[0].size = {20, 0.1, 20};
    const double angle =
        std::atan(std::sqrt(scene.soft[0].contact.friction * scene.rigid[0].contact.friction)) +
        beyond * std::numbers::pi / 180;
    scene.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
    Simulation simulation(scene, options());
    run(simulation, 60);
    const double from = centre(simulation, 2).x();
    run(simulation, 600);
    const double moved = centre(simulation, 2).x() - from;
    if (beyond < 0) {
      EXPECT_LT(moved, 1e-4);
    } else {
      EXPECT_GT(moved, 1);
    }
  }
}

}  // namespace
}  // namespace prosector::test
