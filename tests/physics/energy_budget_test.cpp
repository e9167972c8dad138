// Where energy comes from, and where it must not go to.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "common/anatomy/embedding.h"
#include "common/anatomy/kuhn_box.h"
#include "common/anatomy/midpoint_subdivided.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

// ---- A ball on a cube that keeps its volume

/// What the choice by need puts into a scene.
struct CheapRung {
  const char* name;
  const char *model, *solver;
  int newton_iterations, solver_iterations;
  double solver_tolerance;
};

void PrintTo(const CheapRung& rung, std::ostream* out) {
  *out << rung.name;
}

SceneDesc ball_over_cube(const CheapRung& rung) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("ball", "sphere", {0.03, 0, 0}, {0, 0.13, 0}, 3000)};
  SoftDesc cube = block("cube");
  cube.geometry.size = {0.1, 0.1, 0.1};
  cube.pose.p = {0, 0.0505, 0};
  cube.material.poisson_ratio = 0.499;
  cube.geometry.cell = 0.0333;
  cube.configuration.model = rung.model;
  cube.configuration.element = "tet10";
  cube.configuration.solver = rung.solver;
  cube.configuration.newton_iterations = rung.newton_iterations;
  cube.configuration.solver_iterations = rung.solver_iterations;
  cube.configuration.solver_tolerance = rung.solver_tolerance;
  scene.soft = {cube};
  return scene;
}

/// As a mesh file gives it: a surface vertex on each node.
CompileOptions with_all_nodes_touched() {
  CompileOptions out;
  out.threads = 1;
  out.anatomy = [](const SoftDesc& desc) -> std::optional<Anatomy> {
    const auto cells = static_cast<std::uint32_t>(std::lround(desc.geometry.size.x() / desc.geometry.cell));
    TetMesh tets = kuhn_box(desc.geometry.size, cells, cells, cells);
    for (Vec3& x : tets.positions) x += desc.pose.p - desc.geometry.size / 2;
    TriangleMesh surface = with_boundary(tets).surface;
    return embed(std::move(tets), midpoint_subdivided(std::move(surface))).anatomy;
  };
  return out;
}

class Budget : public testing::TestWithParam<CheapRung> {};

INSTANTIATE_TEST_SUITE_P(
    Rungs, Budget,
    testing::Values(CheapRung{"corotational_multigrid", "fem_corotational", "multigrid", 1, 10, 1e-2},
                    CheapRung{"tissue_multigrid", "fem_neo_hookean", "multigrid", 1, 10, 1e-2}),
    [](const auto& info) { return info.param.name; });

// What falls may turn its weight into motion and strain, and nothing else: 1 % of what the ball falls by and
// of what the cube bears is room for rounding.
TEST_P(Budget, ABallThatLandsOnACubeGivesNoMoreThanItsFall) {
  Simulation simulation(ball_over_cube(GetParam()), with_all_nodes_touched());
  const double start = energy(simulation.step({}));
  double most = start;
  for (int tick = 0; tick < 90; ++tick) most = std::max(most, energy(simulation.step({})));
  EXPECT_LT(most - start, 0.01 * start);
  EXPECT_LT(simulation.max_displacement(2), 0.02) << "it is a cube still";
  EXPECT_GT(simulation.rigid_state(1).pose.p.y(), 0.09) << "the ball lies on it";
}

// ---- What a scene's author is told

/// What compiling a block of that model says about it.
std::string warning_of(const char* model) {
  SceneDesc scene;
  scene.soft = {block()};
  scene.soft[0].configuration.model = model;
  CompileOptions compiled = options();
  std::string said;
  compiled.progress = [&](const std::string& line) {
    if (line.find("warning") != std::string::npos) said += line;
  };
  const Simulation simulation(scene, compiled);
  return said;
}

TEST(Compression, ModelsThatDoNotComeBackFromItSaySoWhenTheyAreChosen) {
  for (const char* model : {"fem_stvk", "fem_linear", "fem_neo_hookean_polynomial", "xpbd"}) {
    const std::string said = warning_of(model);
    EXPECT_NE(said.find(std::string("block: warning: model ") + model), std::string::npos) << said;
    EXPECT_NE(said.find("fem_corotational"), std::string::npos) << "what to take instead: " << said;
  }
  for (const char* model : {"fem_corotational", "fem_neo_hookean", "fem_fibers"})
    EXPECT_EQ(warning_of(model), "") << model;
}

}  // namespace
}  // namespace prosector::test
