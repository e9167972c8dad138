// Sheets on a slope stick below the angle of friction, and slide above it.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "server/physics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double friction = 0.3;
constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;  // m/s²
const double friction_angle = std::atan(friction);

/// The slope lies level, and gravity leans: downhill is +x.
SceneDesc slope(const std::string& model, double angle) {
  SceneDesc scene;
  scene.gravity = gravity * Vec3(std::sin(angle), -std::cos(angle), 0);
  scene.rigid = {table()};
  scene.rigid[0].friction = friction;
  SoftDesc& sheet = scene.soft.emplace_back();
  sheet.name = "sheet";
  sheet.shape = "sheet";
  sheet.model = model;
  sheet.size = {0.08, 0.006, 0.08};
  sheet.cell = 0.02;
  sheet.youngs_modulus = 3e4;
  sheet.friction = friction;
  sheet.damping_mass = 0;
  // Falls from beyond what counts as lying there: what lies starts asleep, wherever it could lie.
  sheet.pose.p = {-0.1, 0.033, 0.003};
  return scene;
}

struct Slid {
  double way = 0;    // m, downhill
  double speed = 0;  // m/s, gained on it
};

constexpr double seconds = 0.5;

/// In so many seconds from when it has come to rest on the slope, or slides evenly.
Slid slide(const std::string& model, double angle) {
  const SceneDesc scene = slope(model, angle);
  Simulation simulation(scene, options());
  const auto sheet = static_cast<BodyId>(scene.rigid.size());
  const auto mean = [&](const VecX& values) { return values.reshaped(3, values.size() / 3).row(0).mean(); };
  // What touches a driven body stays awake, even if that is driven to where it is.
  TickInput awake;
  awake.drives = {{.body = 0, .pose = scene.rigid[0].pose}};
  run(simulation, 36, awake);
  const Motion before = simulation.soft_state(sheet).motion;
  run(simulation, static_cast<int>(seconds * 60), awake);
  EXPECT_FALSE(simulation.asleep(sheet));
  const Motion& after = simulation.soft_state(sheet).motion;
  return {mean(after.x) - mean(before.x), mean(after.v) - mean(before.v)};
}

class ThinFriction : public testing::TestWithParam<const char*> {};

TEST_P(ThinFriction, SticksBelowTheAngleOfFriction) {
  for (const double below : {2.0, 1.0}) {
    const Slid slid = slide(GetParam(), friction_angle - below * degree);
    EXPECT_LT(std::abs(slid.way), 1e-5);
  }
}

TEST_P(ThinFriction, SlidesAboveItAsCoulombHasIt) {
  for (const double above : {2.0, 5.0}) {
    const double angle = friction_angle + above * degree;
    const Slid slid = slide(GetParam(), angle);
    const double expected = gravity * (std::sin(angle) - friction * std::cos(angle));  // m/s²
    EXPECT_NEAR(slid.speed / seconds, expected, 0.001 * expected);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, ThinFriction, testing::Values("xpbd", "mass_spring"));

}  // namespace
}  // namespace prosector::test
