// Rungs of the ladder in scenes: rest, touch, hold, momentum, recovery, save and restore, threads.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "common/anatomy/sheets_and_ropes.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

struct Case {
  std::string model, integrator, shape;
  std::string name() const { return model + "_" + integrator + "_" + shape; }
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name();
}

/// Each substepping method, and each model of springs and positions, on solids and sheets.
std::vector<Case> cases() {
  return {{"fem_corotational", "symplectic_euler", "block"},
          {"fem_neo_hookean", "verlet", "block"},
          {"fem_linear", "rk4", "block"},
          {"mass_spring", "implicit_euler", "block"},
          {"mass_spring", "rk2", "block"},
          {"mass_spring", "explicit_euler", "sheet"},
          {"mass_spring", "bdf2", "sheet"},
          {"mass_spring", "tr_bdf2", "block"},
          {"xpbd", "implicit_euler", "block"},
          {"xpbd", "implicit_euler", "sheet"},
          {"fem_corotational", "tr_bdf2", "block"},
          {"fem_stvk", "implicit_euler", "block"},
          {"fem_fibers", "implicit_euler", "block"}};
}

SoftDesc soft_body(const Case& c) {
  SoftDesc desc = block("body");
  desc.geometry.shape = c.shape;
  desc.configuration.model = c.model;
  desc.configuration.integrator = c.integrator;
  desc.material.youngs_modulus = 2e4;
  desc.material.poisson_ratio = 0.4;
  desc.configuration.newton_iterations = 4;
  desc.material.damping_stiffness = 0.002;
  desc.configuration.substeps = 40;
  if (c.model == "fem_fibers") {  // muscle: fibres, a stiffer end, relaxation
    desc.material.fiber_stiffness = 4e4;
    desc.material.fiber_direction = {1, 0, 1};
    desc.material.regions.push_back({.center = {0.05, 0.1, 0}, .radius = 0.04, .youngs_modulus = 6e4});
    desc.material.relaxation = {{0.3, 0.1}};
  }
  if (c.shape == "sheet") {
    desc.geometry.size = {0.2, 0.004, 0.2};
    desc.pose.p = {0, 0.1, 0};
    desc.material.damping_mass = 2;
  }
  return desc;
}

CompileOptions with_sheets(int threads = 1) {
  CompileOptions out = options(threads);
  const auto solids = out.anatomy;
  out.anatomy = [solids](const SoftDesc& desc) -> std::optional<Anatomy> {
    return desc.geometry.shape == "block" ? solids(desc) : std::nullopt;
  };
  return out;
}

const soft::SoftBodyState& body_state(const Simulation& simulation) {
  return simulation.soft_state(static_cast<BodyId>(simulation.body_count() - 1));
}

double lowest(const Simulation& simulation) {
  const VecX& x = body_state(simulation).motion.x;
  return x.reshaped(3, x.size() / 3).row(1).minCoeff();
}

class Ladder : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Rungs, Ladder, testing::ValuesIn(cases()),
                         [](const auto& info) { return info.param.name(); });

TEST_P(Ladder, FallsOnABallAndStaysBounded) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.05, 0, 0}, {0, 0.026, 0}, 3000)};
  scene.soft = {soft_body(GetParam())};
  scene.soft[0].pose.p.y() = 0.12;
  Simulation simulation(scene, with_sheets());
  // Nothing is near, so it starts in the air.
  double most = 0;
  for (int i = 0; i < 90; ++i) {
    for (const BodyReport& row : simulation.step({}).bodies) EXPECT_FALSE(row.reset) << row.note;
    most = std::max(most, body_state(simulation).motion.v.lpNorm<Eigen::Infinity>());
  }
  EXPECT_LT(most, 5);
  EXPECT_GT(lowest(simulation), -0.006);
  EXPECT_TRUE(is_finite(simulation.rigid_state(1).pose));
}

TEST(LadderContact, ASheetLiesHalfItsThicknessOffTheTable) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {soft_body({"mass_spring", "implicit_euler", "sheet"})};
  scene.soft[0].pose.p.y() = 0.02;
  Simulation simulation(scene, with_sheets());
  run(simulation, 120);
  EXPECT_NEAR(lowest(simulation), scene.soft[0].geometry.size.y() / 2, 2e-4);
}

TEST_P(Ladder, ABallThatHitsItHandsOverItsMomentum) {
  SceneDesc scene;
  scene.gravity.setZero();
  scene.rigid = {part_body("ball", "sphere", {0.04, 0, 0}, {0, 0.2, 0}, 2000)};
  scene.soft = {soft_body(GetParam())};
  scene.soft[0].material.damping_mass = 0;
  scene.soft[0].material.damping_stiffness = 0.005;
  scene.soft[0].configuration.newton_iterations = 40;  // what a solve leaves unsolved is momentum too
  scene.soft[0].configuration.solver_iterations = 2000;
  scene.soft[0].configuration.solver_tolerance = 1e-9;
  scene.soft[0].pose.p.setZero();
  Simulation simulation(scene, with_sheets());
  const soft::SoftBody& body = simulation.soft(1);
  // A checkpoint with the ball on its way.
  auto bytes = simulation.checkpoint();
  const Vec3 still = Vec3::Zero(), moving(0, -1, 0);
  const Vec3 at = simulation.rigid_state(0).pose.p;
  auto found = std::search(bytes.begin(), bytes.end(), reinterpret_cast<const std::uint8_t*>(at.data()),
                           reinterpret_cast<const std::uint8_t*>(at.data() + 3));
  ASSERT_NE(found, bytes.end());
  found += 7 * sizeof(double);  // position, orientation
  ASSERT_EQ(std::memcmp(&*found, still.data(), sizeof still), 0);
  std::memcpy(&*found, moving.data(), sizeof moving);
  bytes[static_cast<std::size_t>(found - bytes.begin()) + 6 * sizeof(double)] = 0;  // awake
  simulation.restore(bytes);
  const double mass = 2000 * M_PI / 6 * std::pow(0.04, 3);
  const auto momentum = [&] {
    Vec3 p = mass * simulation.rigid_state(0).linear_velocity;
    const VecX& v = simulation.soft_state(1).motion.v;
    for (Eigen::Index i = 0; i < body.nodes(); ++i) p += body.node_mass()[i] * v.segment<3>(3 * i);
    return p;
  };
  const Vec3 before = momentum();
  EXPECT_NEAR(before.y(), -mass, 1e-3 * mass);
  for (int i = 0; i < 30; ++i) simulation.step({});
  EXPECT_GT(simulation.rigid_state(0).linear_velocity.y(), -0.95) << "did not hit";
  EXPECT_LT((momentum() - before).norm(), 2e-3 * mass);
}

TEST_P(Ladder, IsPressedHeldAndReleasedByAHand) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {soft_body(GetParam())};
  if (GetParam().shape == "sheet") scene.soft[0].pose.p.y() = 0.005;
  Simulation simulation(scene, with_sheets());
  const double press = GetParam().shape == "sheet" ? 0.015 : 0.03;
  run(simulation, 10, appear({0, 0.15, 0.05}));
  run(simulation, 30, target({0, press, 0.05}));
  run(simulation, 1, event(HandEvent::Kind::grasp, {0, press, 0.05}));
  ASSERT_TRUE(simulation.hands()[0].holding.has_value());
  for (int i = 0; i < 44; ++i) simulation.step(target({0, press + 0.005 * i, 0.05}));
  run(simulation, 20, target({0, 0.25, 0.05}));
  EXPECT_GT(lowest(simulation), 0.02) << "was not lifted";
  EXPECT_GT(simulation.hands()[0].pose.p.y(), 0.15);
  run(simulation, 1, event(HandEvent::Kind::release, {0, 0.25, 0.05}));
  EXPECT_FALSE(simulation.hands()[0].holding.has_value());
  run(simulation, 1, event(HandEvent::Kind::vanish, {0, 0.25, 0.05}));  // it may lie on the hand
  run(simulation, 45);
  EXPECT_LT(lowest(simulation), 0.02) << "did not fall";
  EXPECT_TRUE(body_state(simulation).motion.x.allFinite());
}

SceneDesc busy(const Case& c) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.04, 0, 0}, {0.01, 0.2, 0}, 2000)};
  scene.soft = {soft_body(c)};
  return scene;
}

TEST_P(Ladder, SameHashForAnyThreadsAndAfterRestore) {
  std::vector<std::uint64_t> results;
  std::vector<std::uint8_t> saved;
  for (const int threads : {1, 2, 4}) {
    Simulation simulation(busy(GetParam()), with_sheets(threads));
    run(simulation, 20);
    saved = simulation.checkpoint();
    run(simulation, 10);
    results.push_back(simulation.state_hash());
  }
  Simulation restored(busy(GetParam()), with_sheets());
  restored.restore(saved);
  run(restored, 10);
  results.push_back(restored.state_hash());
  for (const std::uint64_t hash : results) EXPECT_EQ(hash, results[0]);
}

TEST_P(Ladder, WhatOverflowsIsStoppedAndReported) {
  Simulation simulation(busy(GetParam()), with_sheets());
  run(simulation, 15);
  const soft::SoftBodyState before = body_state(simulation);
  auto bytes = simulation.checkpoint();
  const auto* begin = reinterpret_cast<const std::uint8_t*>(before.motion.v.data());
  const auto size = static_cast<std::size_t>(before.motion.v.size()) * sizeof(double);
  const auto found = std::search(bytes.begin(), bytes.end(), begin, begin + size);
  ASSERT_NE(found, bytes.end());
  for (Eigen::Index i = 0; i < before.motion.v.size(); ++i) {
    const double huge = 1e300;
    std::memcpy(&*found + static_cast<std::size_t>(i) * sizeof huge, &huge, sizeof huge);
  }
  simulation.restore(bytes);
  bool reset = false;
  for (const BodyReport& row : simulation.step({}).bodies) reset = reset || row.reset;
  EXPECT_TRUE(reset || body_state(simulation).asleep);
  EXPECT_TRUE(body_state(simulation).motion.x.allFinite());
  run(simulation, 30);
  EXPECT_TRUE(body_state(simulation).motion.x.allFinite());
  EXPECT_TRUE(is_finite(simulation.rigid_state(1).pose));
}

TEST(LadderReport, SaysHowItWasSteppedAndWhyItWasRefused) {
  SceneDesc scene;
  scene.rigid = {table()};
  scene.soft = {soft_body({"fem_corotational", "verlet", "block"})};
  scene.soft[0].pose.p.y() = 0.2;
  const auto row_of = [&](const SceneDesc& s) {
    Simulation simulation(s, with_sheets());
    run(simulation, 1, appear({0, 0.24, 0.05}));
    for (int i = 0; i < 60; ++i) {
      const StepReport& report = simulation.step(target({0, 0.2, 0.05}));
      if (!report.bodies.empty()) return report.bodies.front();
    }
    return BodyReport{};
  };
  const BodyReport fine = row_of(scene);
  EXPECT_GT(fine.substep, 0);
  EXPECT_TRUE(fine.converged);
  EXPECT_NE(fine.note.find("substeps"), std::string::npos) << fine.note;
  scene.soft[0].configuration.max_substeps = 2;
  const BodyReport refused = row_of(scene);
  EXPECT_EQ(refused.substep, 0);
  EXPECT_FALSE(refused.converged);
  EXPECT_NE(refused.note.find("2 are allowed"), std::string::npos) << refused.note;
  scene.soft[0].configuration.integrator = "rk2";
  scene.soft[0].material.damping_mass = scene.soft[0].material.damping_stiffness = 0;
  EXPECT_NE(row_of(scene).note.find("is unstable at any step size"), std::string::npos) << row_of(scene).note;
}

/// The checkpoint with the body's positions replaced, and awake.
std::vector<std::uint8_t> with_positions(Simulation& simulation, const VecX& x) {
  auto bytes = simulation.checkpoint();
  const VecX& now = body_state(simulation).motion.x;
  const auto* begin = reinterpret_cast<const std::uint8_t*>(now.data());
  const auto size = static_cast<std::size_t>(now.size()) * sizeof(double);
  const auto found = std::search(bytes.begin(), bytes.end(), begin, begin + size);
  EXPECT_NE(found, bytes.end());
  std::memcpy(&*found, x.data(), size);
  // After x come v, x_prev, v_prev and the warm start, each with its size, then the history's flag and
  // sleep's.
  const auto at = static_cast<std::size_t>(found - bytes.begin());
  bytes[at + 5 * size + 4 * sizeof(std::uint64_t) + 1] = 0;
  return bytes;
}

/// Largest distance of a node from the rest shape, after the rigid motion that fits best.
double misfit(const soft::SoftBody& body, const VecX& x) {
  const VecX rest = body.initial_state().motion.x;
  soft::SoftBodyState fitted = body.initial_state();
  fitted.motion.x = x;
  soft::unfold(rest, body.node_mass(), true, fitted);
  double most = 0;
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    most = std::max(most, (fitted.motion.x - x).segment<3>(3 * i).norm());
  return most;
}

class Recovers : public testing::TestWithParam<Case> {};
std::vector<Case> solids() {
  std::vector<Case> out;
  for (const soft::ModelRow& row : soft::models()) out.push_back({row.name, "implicit_euler", "block"});
  for (const char* by : {"symplectic_euler", "verlet", "rk4"})
    out.push_back({"fem_corotational", by, "block"});
  return out;
}
INSTANTIATE_TEST_SUITE_P(Rungs, Recovers, testing::ValuesIn(solids()),
                         [](const auto& info) { return info.param.name(); });

TEST_P(Recovers, ItsShapeFromRuinedStartsOrReportsAReset) {
  SceneDesc scene;
  scene.gravity.setZero();
  scene.rigid = {part_body("far", "sphere", {0.02, 0, 0}, {5, 5, 5})};
  scene.soft = {soft_body(GetParam())};
  scene.soft[0].geometry.cell = 0.03;
  scene.soft[0].material.damping_mass = 2;
  scene.soft[0].material.damping_stiffness = 0.01;
  std::mt19937_64 random(5);
  const auto noise = [&](Eigen::Index n) {
    return VecX::NullaryExpr(n, [&] { return std::uniform_real_distribution<double>(-0.1, 0.1)(random); });
  };
  for (const char* start : {"random", "flat", "point", "mirrored"}) {
    Simulation simulation(scene, with_sheets());
    const soft::SoftBody& body = simulation.soft(1);
    VecX x = body.initial_state().motion.x;
    const auto scaled = [&](const Vec3& s) -> VecX {
      return (s.asDiagonal() * x.reshaped(3, x.size() / 3)).reshaped();
    };
    // Small strain's own rest shapes include turns that are no rotations: from here it finds one of those.
    if (start == std::string("random") && GetParam().model == "fem_linear") continue;
    if (start == std::string("random")) x += noise(x.size());
    if (start == std::string("flat")) x = scaled({1, 0, 1});
    if (start == std::string("point")) x = scaled({0, 0, 0});
    if (start == std::string("mirrored")) x = scaled({-1, 1, 1});
    simulation.restore(with_positions(simulation, x));
    std::string resets;
    for (int i = 0; i < 300; ++i)
      for (const BodyReport& row : simulation.step({}).bodies)
        if (row.reset) resets += row.note + "; ";
    const VecX& now = body_state(simulation).motion.x;
    ASSERT_TRUE(now.allFinite()) << start;
    EXPECT_LT(misfit(body, now), 1e-3) << start << ": " << resets;
  }
}

}  // namespace
}  // namespace prosector::test
