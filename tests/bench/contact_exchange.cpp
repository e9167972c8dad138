// Momentum exchange: a ball that falls on a floating block of tissue, with implicit and substepped
// integrators, and a ball that bounces off a plate on tissue.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double g = 1;  // m/s², acts on the ball only

SceneDesc floating(const std::string& integrator) {
  SceneDesc scene;
  scene.gravity = {0, -g, 0};
  scene.soft = {test::block()};
  SoftDesc& block = scene.soft[0];
  block.gravity = false;
  block.material.damping_mass = 0;
  block.configuration.integrator = integrator;
  block.configuration.newton_iterations = 30;
  block.configuration.solver_iterations = 400;
  block.configuration.solver_tolerance = 1e-8;
  scene.rigid = {test::part_body("ball", "sphere", {0.04, 0, 0}, {0.015, 0.5, 0}, 3000)};
  return scene;
}

void fall_on_floating(ContactRows& rows, const std::string& integrator) {
  const SceneDesc scene = floating(integrator);
  ContactRun run(scene);
  const Simulation& s = run.simulation();
  const double mass = 3000 * 4.0 / 3 * std::numbers::pi * 8e-6;
  const double start = mass * g * 0.5, fallen = mass * g * 0.42;
  double lost = 0, exchanged = 0, gained = 0;
  Vec3 reported = Vec3::Zero();  // impulse on the block reported by exchanges()
  double impulse_error = 0;
  for (int tick = 1; tick <= 90; ++tick) {
    run.step();
    const Vec3 of_block = soft_momentum(s, 1);
    const Vec3 missing = of_block + rigid_momentum(s, 0, mass) - mass * tick * run.h() * scene.gravity;
    for (const Exchange& touch : s.exchanges()) reported += touch.a == 1 ? touch.impulse : -touch.impulse;
    exchanged = std::max(exchanged, of_block.norm());
    lost = std::max(lost, missing.norm());
    impulse_error = std::max(impulse_error, (reported - of_block).norm());
    gained = std::max(gained, run.energy() - start);
  }
  const std::string setting = "ball on floating tissue, " + integrator;
  rows.add(run, setting, {"relative momentum loss", "1", lost / exchanged, 0, 1e-3});
  rows.add(run, setting, {"relative error of reported impulse", "1", impulse_error / exchanged, 0, 1e-3});
  rows.add(run, setting, {"relative energy gain", "1", gained / fallen, 0, 1e-3});
}

void bounce_beside_tissue(ContactRows& rows, double restitution) {
  SceneDesc scene;
  scene.rigid = {test::table(), test::part_body("plate", "box", {0.12, 0.02, 0.12}, {0, 0.0702, 0}, 8000),
                 test::part_body("ball", "sphere", {0.04, 0, 0}, {0, 0.2, 0})};
  scene.rigid[1].contact.restitution = scene.rigid[2].contact.restitution = std::sqrt(restitution);
  scene.soft = {test::block()};
  scene.soft[0].material.youngs_modulus = 5e4;
  ContactRun run(scene);
  const double plate = 8000 * 0.12 * 0.12 * 0.02, ball = 1000 * 4.0 / 3 * std::numbers::pi * 8e-6;
  double before = 0, after = 0;
  double start = 0, gained = 0;
  for (int tick = 0; tick < 30; ++tick) {
    run.step();
    const double v = run.simulation().rigid_state(2).linear_velocity.y();
    before = std::min(before, v);
    after = std::max(after, v);
    if (tick == 0) start = run.energy();
    gained = std::max(gained, run.energy() - start);
  }
  // Newton's law of restitution; the plate, 34 times as heavy, is initially at rest.
  const double expected = (restitution * plate - ball) / (plate + ball);
  const std::string setting = fmt::format("ball on a plate on tissue, restitution {}", restitution);
  rows.add(run, setting, {"rebound speed over impact speed", "1", -after / before, expected, 0.05});
  rows.add(run, setting, {"relative energy gain", "1", gained / (ball * 9.81 * 0.1), 0, 1e-2});
}

}  // namespace

void exchange_case(ContactRows& rows, bool quick) {
  fall_on_floating(rows, "implicit_euler");
  if (quick) return;
  fall_on_floating(rows, "tr_bdf2");
  fall_on_floating(rows, "symplectic_euler");
  for (const double restitution : {0.5, 0.8}) bounce_beside_tissue(rows, restitution);
}

}  // namespace prosector
