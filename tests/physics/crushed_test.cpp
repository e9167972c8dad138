// Laws that do not carry a body's own weight: it begins, and stays, in a shape that tissue can have.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "tests/physics/patched_state.h"
#include "tests/physics/scenes.h"
#include "tests/play/judge.h"

namespace prosector::test {
namespace {

constexpr BodyId ball = 1;

/// A heavy, soft ball that a table carries at a point.
SceneDesc soft_ball(const std::string& model, double youngs_modulus) {
  SceneDesc scene;
  scene.rigid = {table()};
  SoftDesc& soft = scene.soft.emplace_back(block("ball"));
  soft.geometry.shape = "ball";
  soft.geometry.size = {0.12, 0.12, 0.12};
  soft.pose.p = {0, 0.06, 0};
  soft.geometry.cell = 0.018;
  soft.geometry.surface_cell = 0.01;
  soft.material.youngs_modulus = youngs_modulus;
  soft.configuration.model = model;
  return scene;
}

class CrushedByItsWeight : public testing::TestWithParam<std::string> {};

TEST_P(CrushedByItsWeight, BeginsAndStaysWholeAndTheAuthorHearsOfIt) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / fmt::format("prosector-crushed.{}", getpid());
  std::filesystem::create_directories(folder);
  CompileOptions compiled = options();
  compiled.cache_dir = folder;
  std::string said;
  compiled.progress = [&](const std::string& line) { said += line + "\n"; };
  const SceneDesc scene = soft_ball(GetParam(), 3000);
  Simulation simulation(scene, compiled);
  const bool crushed = simulation.soft(ball).recovery().is_kept();
  EXPECT_EQ(said.find("its own weight crushes it") != std::string::npos, crushed) << said;
  EXPECT_LT(soft::inverted_share(simulation.soft(ball).linear_tets(), simulation.soft_state(ball).motion.x),
            0.05);
  // From the cache as from the compiler.
  Simulation again(scene, compiled);
  std::filesystem::remove_all(folder);
  ASSERT_EQ(again.state_hash(), simulation.state_hash());
  const Judge judge(simulation);
  run(simulation, 30, appear({0, 0.2, 0}));
  run(again, 30, appear({0, 0.2, 0}));
  EXPECT_EQ(again.state_hash(), simulation.state_hash());
  run(simulation, 120, target({0, 0.1, 0}));
  run(simulation, 120, target({0, 0.3, 0}));
  const Finding found = judge.look(simulation);
  EXPECT_TRUE(found.good()) << found.where;
  EXPECT_EQ(simulation.soft_state(ball).recovering, crushed);
}

INSTANTIATE_TEST_SUITE_P(Models, CrushedByItsWeight,
                         testing::Values("fem_stvk", "fem_linear", "fem_neo_hookean",
                                         "fem_neo_hookean_polynomial", "mass_spring", "xpbd"),
                         [](const auto& info) { return info.param; });

// St. Venant and Kirchhoff's law has no barrier: it is the one that this is for.
TEST(CrushedByItsWeight, IsWhatStVenantAndKirchhoffsLawDoesAndNoneThatIsStiffer) {
  EXPECT_TRUE(Simulation(soft_ball("fem_stvk", 3000), options()).soft(ball).recovery().is_kept());
  EXPECT_FALSE(Simulation(soft_ball("fem_stvk", 30000), options()).soft(ball).recovery().is_kept());
}

class CorotatedLinear : public testing::TestWithParam<int> {};

// Under fem_linear a free body swells as it turns. It is never as large as what counts as ruined.
TEST_P(CorotatedLinear, StaysWithinItsVolumeHoweverItIsTurned) {
  const double angle = 0.1 * GetParam();  // rad
  SceneDesc scene;
  scene.soft = {block("block")};
  scene.soft[0].configuration.model = "fem_linear";
  Simulation simulation(scene, options());  // it falls
  ASSERT_FALSE(simulation.asleep(0));
  const VecX now = simulation.soft_state(0).motion.x;
  VecX turned = now;
  auto nodes = turned.reshaped(3, turned.size() / 3);
  const Vec3 middle = nodes.rowwise().mean();
  const Mat3 turn = Eigen::AngleAxisd(angle, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  nodes = (turn * (nodes.colwise() - middle)).colwise() + middle;
  simulation.restore(with_values(simulation.checkpoint(), now, turned));
  double most = 0;
  for (int tick = 0; tick < 120; ++tick) {
    simulation.step({});
    most = std::max(most,
                    soft::volume_share(simulation.soft(0).linear_tets(), simulation.soft_state(0).motion.x));
  }
  EXPECT_LT(most, 1.3);
}

INSTANTIATE_TEST_SUITE_P(Angles, CorotatedLinear, testing::Range(1, 16));

}  // namespace
}  // namespace prosector::test
