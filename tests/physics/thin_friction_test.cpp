// Sheets on a slope, and on a sheet that lies there, stick below the angle of friction, and slide above it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"
#include "tests/physics/thrown.h"

namespace prosector::test {
namespace {

constexpr double friction = 0.3;
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // m/s²
const double friction_angle = std::atan(friction);

SoftDesc sheet(const std::string& name, const std::string& model, double length, double width) {
  SoftDesc sheet;
  sheet.name = name;
  sheet.geometry.shape = "sheet";
  sheet.configuration.model = model;
  sheet.geometry.size = {length, 0.006, width};
  sheet.geometry.cell = 0.02;
  sheet.material.youngs_modulus = 3e4;
  sheet.contact.friction = friction;
  sheet.material.damping_mass = 0;
  return sheet;
}

SceneDesc slope(double angle) {
  SceneDesc scene;
  scene.gravity = gravity * Vec3(std::sin(angle), -std::cos(angle), 0);
  scene.rigid = {table()};
  scene.rigid[0].contact.friction = friction;
  return scene;
}

/// The slope lies level, and gravity leans: downhill is +x.
SceneDesc on_a_slope(const std::string& model, double angle) {
  SceneDesc scene = slope(angle);
  SoftDesc& upper = scene.soft.emplace_back(sheet("sheet", model, 0.08, 0.08));
  // Falls from beyond what counts as lying there: what lies starts asleep, wherever it could lie.
  upper.pose.p = {-0.1, 0.033, 0.003};
  return scene;
}

/// `turned`: rad, of the upper sheet's cells against the held one's.
SceneDesc on_a_held_sheet(const std::string& model, double angle, double turned) {
  SceneDesc scene = slope(angle);
  SoftDesc& lower = scene.soft.emplace_back(sheet("lower", model, 0.6, 0.14));
  lower.pose.p = {0, 0.0033, 0};
  lower.attach = {{.center = lower.pose.p, .radius = 1, .stiffness = 1e5}};
  SoftDesc& upper = scene.soft.emplace_back(sheet("upper", model, 0.08, 0.08));
  upper.pose.p = {-0.22, 0.036, 0.003};
  upper.pose.q = Quat(Eigen::AngleAxisd(turned, Vec3::UnitY()));
  return scene;
}

double mean_x(const VecX& values) {
  return values.reshaped(3, values.size() / 3).row(0).mean();
}

struct Slid {
  double way = 0;    // m, downhill
  double speed = 0;  // m/s, gained on it
};

constexpr double seconds = 0.5;

/// What the last sheet does in so many seconds from when it has come to rest, or slides evenly.
Slid slide(const SceneDesc& scene) {
  Simulation simulation(scene, options());
  const auto sheet = static_cast<BodyId>(scene.rigid.size() + scene.soft.size() - 1);
  // What touches a driven body stays awake, even if that is driven to where it is.
  TickInput awake;
  awake.kinematic_targets = {{.body = 0, .pose = scene.rigid[0].pose}};
  run(simulation, 36, awake);
  const soft::Motion before = simulation.soft_state(sheet).motion;
  run(simulation, static_cast<int>(seconds * 60), awake);
  EXPECT_FALSE(simulation.asleep(sheet));
  const soft::Motion& after = simulation.soft_state(sheet).motion;
  return {mean_x(after.x) - mean_x(before.x), mean_x(after.v) - mean_x(before.v)};
}

/// m/s², of what slides.
double acceleration(double angle) {
  return gravity * (std::sin(angle) - friction * std::cos(angle));
}

class ThinFriction : public testing::TestWithParam<const char*> {};

TEST_P(ThinFriction, SticksBelowTheAngleOfFriction) {
  for (const double below : {2.0, 1.0}) {
    const Slid slid = slide(on_a_slope(GetParam(), friction_angle - below * degree));
    EXPECT_LT(std::abs(slid.way), 1e-5);
  }
}

TEST_P(ThinFriction, SlidesAboveItAsCoulombHasIt) {
  for (const double above : {2.0, 5.0}) {
    const double angle = friction_angle + above * degree;
    const double expected = acceleration(angle);
    EXPECT_NEAR(slide(on_a_slope(GetParam(), angle)).speed / seconds, expected, 0.001 * expected);
  }
}

TEST_P(ThinFriction, SticksToASheetBelowTheAngleOfFriction) {
  for (const double turned : {0.0, 0.3}) {
    const Slid slid = slide(on_a_held_sheet(GetParam(), friction_angle - degree, turned));
    EXPECT_LT(std::abs(slid.way), 1e-4) << turned;
  }
}

TEST_P(ThinFriction, SlidesOnASheetAboveIt) {
  for (const auto& [above, turned] : {std::pair{1.0, 0.0}, {2.0, 0.3}, {5.0, 0.0}}) {
    const double angle = friction_angle + above * degree;
    const double expected = acceleration(angle);
    const Slid slid = slide(on_a_held_sheet(GetParam(), angle, turned));
    EXPECT_NEAR(slid.speed / seconds, expected, 0.1 * expected) << above;
  }
}

/// On ice: what one sheet loses the other gets, until they go together.
TEST_P(ThinFriction, SheetTakesAFreeSheetAlong) {
  SceneDesc scene = slope(0);
  scene.rigid[0].contact.friction = 0;
  scene.soft = {sheet("lower", GetParam(), 0.2, 0.14), sheet("upper", GetParam(), 0.08, 0.08)};
  scene.soft[0].pose.p = {0, 0.0035, 0};
  scene.soft[1].pose.p = {-0.03, 0.036, 0.003};
  constexpr double speed = 0.3;  // m/s
  Simulation simulation(scene, options());
  run(simulation, 10);
  throw_body(simulation, 2, {speed, 0, 0});
  const auto along = [&](BodyId body) { return momentum(simulation, body).x(); };
  const double start = along(1) + along(2);
  run(simulation, 18);
  EXPECT_NEAR(along(1) + along(2), start, 1e-3 * start);
  const double together = speed * 0.08 * 0.08 / (0.08 * 0.08 + 0.2 * 0.14);
  EXPECT_NEAR(mean_x(simulation.soft_state(2).motion.v), together, 0.02 * speed);
}

INSTANTIATE_TEST_SUITE_P(Models, ThinFriction, testing::Values("xpbd", "mass_spring"));

}  // namespace
}  // namespace prosector::test
