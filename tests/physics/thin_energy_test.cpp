// Thin bodies that fall on each other and on thin rigid ones gain no energy by it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double length = 0.12, thickness = 0.006;  // m, of sheets

struct Made {
  const char* model;
  double youngs_modulus;  // Pa
  int seed;               // where exactly it strikes
};

std::string name(const testing::TestParamInfo<Made>& info) {
  return fmt::format("{}_{:.0f}_{}", info.param.model, info.param.youngs_modulus, info.param.seed);
}

SoftDesc thin(const std::string& name, const std::string& shape, const Made& made) {
  SoftDesc soft;
  soft.name = name;
  soft.geometry.shape = shape;
  soft.configuration.model = made.model;
  soft.geometry.size = shape == "sheet" ? Vec3(length, thickness, length) : Vec3(0.24, 0.01, 0.01);
  soft.geometry.cell = 0.012;
  soft.material.youngs_modulus = made.youngs_modulus;
  return soft;
}

Quat turned(double angle) {
  return Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
}

struct Gain {
  double over_start = 0;   // J: at most, since all bodies are awake
  double over_lowest = 0;  // J: at most, since any time before
};

Gain drop(const SceneDesc& scene) {
  Simulation simulation(scene, options());
  Gain out;
  std::optional<double> start;
  double lowest = 0;
  for (int tick = 0; tick < 45; ++tick) {
    const StepReport& report = simulation.step({});
    if (report.asleep_bodies > 0) continue;  // what sleeps is not counted
    const double now = report.kinetic_energy + report.elastic_energy + report.potential_energy;
    if (!start) start = lowest = now;
    lowest = std::min(lowest, now);
    out.over_start = std::max(out.over_start, now - *start);
    out.over_lowest = std::max(out.over_lowest, now - lowest);
  }
  EXPECT_TRUE(start);
  EXPECT_TRUE(simulation.soft_state(static_cast<BodyId>(scene.rigid.size())).motion.x.allFinite());
  return out;
}

/// J, of a body that has fallen so far.
double fallen(const SoftDesc& soft, double height) {
  return soft.material.density * soft.geometry.size.prod() * 9.81 * height;
}

constexpr double rounding = 1e-6;  // J

class ThinEnergy : public testing::TestWithParam<Made> {
 protected:
  double phase() const { return 0.7 * GetParam().seed; }
};

TEST_P(ThinEnergy, SheetOnASheet) {
  SceneDesc scene;
  scene.soft = {thin("lower", "sheet", GetParam()), thin("upper", "sheet", GetParam())};
  scene.rigid = {table()};
  scene.soft[0].pose.p = {0, 0.004, 0};
  scene.soft[1].pose.p = {0.01 * std::cos(phase()), 0.035, 0.01 * std::sin(phase())};
  scene.soft[1].pose.q = turned(0.3 + phase());
  const Gain gain = drop(scene);
  EXPECT_LE(gain.over_start, rounding);
  EXPECT_LE(gain.over_lowest, 0.005 * fallen(scene.soft[1], 0.025));
}

TEST_P(ThinEnergy, RopeOnASheetHeldAtItsEnds) {
  SceneDesc scene;
  scene.soft = {thin("sheet", "sheet", GetParam()), thin("rope", "rope", GetParam())};
  scene.soft[0].geometry.size = {0.3, thickness, length};
  for (const double x : {-0.15, 0.15})
    scene.soft[0].attach.push_back({.center = {x, 0, 0}, .radius = 0.06, .stiffness = 1e8});
  scene.soft[1].pose.p = {0.01, 0.03, 0.004};
  scene.soft[1].pose.q = turned(1.4 + phase() / 10);
  const Gain gain = drop(scene);
  EXPECT_LE(gain.over_start, rounding);
  // The sheet sags by centimetres more while the rope hits it: its weight is most of what falls.
  EXPECT_LE(gain.over_lowest, 0.015 * fallen(scene.soft[0], 0.01) + 0.015 * fallen(scene.soft[1], 0.04));
}

/// Half as thick as a cell of it is wide, so the sheet's vertices fall past it and its faces carry.
TEST_P(ThinEnergy, SheetOnAThinRod) {
  SceneDesc scene;
  RigidDesc rod = part_body("rod", "capsule", {0.01, 0.3, 0.01}, {0, 0, 0});
  rod.fixed = true;
  rod.contact.friction = 2;
  rod.pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()));
  scene.rigid = {rod};
  scene.soft = {thin("sheet", "sheet", GetParam())};
  scene.soft[0].geometry.size = {0.3, thickness, 0.2};
  scene.soft[0].geometry.cell = 0.02;
  scene.soft[0].contact.friction = 2;
  scene.soft[0].pose.p = {0.01 * std::cos(phase()), 0.1, 0};
  scene.soft[0].pose.q = turned(0.2 + phase());
  const Gain gain = drop(scene);
  EXPECT_LE(gain.over_start, rounding);
  if (GetParam().model == std::string("xpbd")) {
    EXPECT_LE(gain.over_lowest, 0.01 * fallen(scene.soft[0], 0.09));
  }
}

INSTANTIATE_TEST_SUITE_P(Made, ThinEnergy,
                         testing::Values(Made{"xpbd", 1e4, 0}, Made{"xpbd", 1e4, 1}, Made{"xpbd", 3e4, 0},
                                         Made{"xpbd", 3e4, 2}, Made{"xpbd", 2e5, 0}, Made{"xpbd", 2e5, 1},
                                         Made{"mass_spring", 1e4, 2}, Made{"mass_spring", 3e4, 2},
                                         Made{"mass_spring", 3e4, 0}, Made{"mass_spring", 2e5, 1}),
                         name);

}  // namespace
}  // namespace prosector::test
