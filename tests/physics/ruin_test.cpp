// However a body was ruined, and whatever is about it then: it is itself again within a second.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/patched_state.h"
#include "tests/physics/scenes.h"
#include "tests/play/judge.h"
#include "tests/random.h"

namespace prosector::test {
namespace {

constexpr BodyId cube = 1, slab = 2;
constexpr double side = 0.05, cell = side / 4;  // m, of the cube

enum class Ruin { mirrored, flat, point, scrambled, swollen };
enum class Company { none, hand, tissue };

struct Case {
  std::string model;
  Ruin ruin;
  Company company;
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  const char* ruins[] = {"mirrored", "flat", "point", "scrambled", "swollen"};
  const char* companies[] = {"alone", "under_a_hand", "in_tissue"};
  return fmt::format("{}_{}_{}", info.param.model, ruins[static_cast<int>(info.param.ruin)],
                     companies[static_cast<int>(info.param.company)]);
}

std::vector<Case> cases() {
  std::vector<Case> out;
  for (const char* model : {"fem_corotational", "fem_linear", "fem_stvk", "fem_neo_hookean",
                            "fem_neo_hookean_polynomial", "fem_fibers", "mass_spring", "xpbd"})
    for (const Ruin ruin : {Ruin::mirrored, Ruin::flat, Ruin::point, Ruin::scrambled, Ruin::swollen})
      for (const Company company : {Company::none, Company::hand, Company::tissue})
        out.push_back({model, ruin, company});
  return out;
}

/// A cube that falls on a table, and a slab far beside it.
SceneDesc cube_and_slab(const std::string& model) {
  SceneDesc scene;
  scene.rigid = {table()};
  for (const char* name : {"cube", "slab"}) {
    SoftDesc& soft = scene.soft.emplace_back(block(name));
    soft.configuration.model = model;
    soft.geometry.cell = soft.geometry.surface_cell = cell;
  }
  scene.soft[0].geometry.size = {side, side, side};
  scene.soft[0].pose.p = {0, side / 2 + 0.05, 0};
  scene.soft[1].geometry.size = {0.12, 0.04, 0.12};
  scene.soft[1].pose.p = {0.3, 0.02 + 0.05, 0};
  return scene;
}

/// Node positions of a body ruined about its middle, then carried by `shift`.
VecX ruined(const VecX& x, Ruin ruin, const Vec3& shift) {
  VecX out = x;
  auto nodes = out.reshaped(3, out.size() / 3);
  const Vec3 middle = nodes.rowwise().mean();
  nodes.colwise() -= middle;
  Random random(20100611);
  switch (ruin) {
    case Ruin::mirrored:
      nodes.row(0) *= -1;
      break;
    case Ruin::flat:
      nodes.row(1) *= 1e-3;
      break;
    case Ruin::point:
      nodes *= 1e-3;
      break;
    case Ruin::scrambled:
      for (Eigen::Index i = 0; i < nodes.cols(); ++i) nodes.col(i) = random.point(side / 2);
      break;
    case Ruin::swollen:
      nodes *= 1.6;
      break;
  }
  nodes.colwise() += middle + shift;
  return out;
}

class RuinedBody : public testing::TestWithParam<Case> {};

TEST_P(RuinedBody, IsItselfWithinASecond) {
  const Case& c = GetParam();
  Simulation simulation(cube_and_slab(c.model), options());
  const Judge judge(simulation);
  if (c.company == Company::hand) run(simulation, 1, appear({0, 0.15, 0}));
  run(simulation, 12);  // they have landed
  ASSERT_FALSE(simulation.asleep(cube));
  const Vec3 shift = c.company == Company::tissue ? Vec3(0.3, 0, 0) : Vec3(0, 0, 0);
  const VecX now = simulation.soft_state(cube).motion.x;
  simulation.restore(with_values(simulation.checkpoint(), now, ruined(now, c.ruin, shift)));
  TickInput press;
  if (c.company == Company::hand) press = target({0, side, 0});
  const auto ticks = static_cast<int>(simulation.scene().tick_rate);
  run(simulation, ticks, press);
  const Bounds bounds{.most_overlap = 0.25 * cell};
  Finding found = judge.look(simulation, bounds);
  EXPECT_TRUE(found.good()) << found.where;
  // It stays so, and nothing was hurled away.
  run(simulation, ticks / 2, press);
  found = judge.look(simulation, bounds);
  EXPECT_TRUE(found.good()) << found.where << ", later";
  for (const BodyId body : {cube, slab}) {
    const Vec3 middle =
        simulation.soft_state(body).motion.x.reshaped(3, simulation.soft(body).nodes()).rowwise().mean();
    EXPECT_LT((middle - Vec3(0.15, 0, 0)).norm(), 0.5) << simulation.name(body);
  }
}

/// Which way bodies are led is state: what is half out looks as if it had come from elsewhere.
TEST(EntangledBodies, AreLedOnAlikeAfterRestore) {
  const SceneDesc scene = cube_and_slab("fem_corotational");
  Simulation simulation(scene, options()), other(scene, options());
  run(simulation, 12);
  const VecX now = simulation.soft_state(cube).motion.x;
  simulation.restore(with_values(simulation.checkpoint(), now, ruined(now, Ruin::swollen, {0.3, 0, 0})));
  bool led = false;
  for (int tick = 0; tick < 60; ++tick) {
    if (tick == 10) other.restore(simulation.checkpoint());
    const StepReport& report = simulation.step({});
    led = led || std::any_of(report.bodies.begin(), report.bodies.end(), [](const BodyReport& row) {
            return row.note.find("being separated") != std::string::npos;
          });
    if (tick < 10) continue;
    other.step({});
    ASSERT_EQ(simulation.state_hash(), other.state_hash()) << tick;
  }
  EXPECT_TRUE(led);
}

INSTANTIATE_TEST_SUITE_P(Models, RuinedBody, testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace prosector::test
