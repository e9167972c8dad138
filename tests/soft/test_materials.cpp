// Bodies of several materials: every model against a stack of two layers, whose answer is known.

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/laws/material.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "tests/soft/kuhn.h"
#include "tests/soft/print_rows.h"
#include "tests/soft/stepper.h"

namespace prosector {
namespace {

const Vec3 size(0.2, 0.1, 0.1);

/// Stiffness changes at half the length.
SoftDesc layered(const std::string& model) {
  SoftDesc desc;
  desc.name = "stack";
  desc.configuration.model = model;
  desc.configuration.solver = "direct";
  desc.material.youngs_modulus = 1e4;
  desc.material.poisson_ratio = 0.3;
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  RegionDesc hard;
  hard.center = Vec3(0.15, 0.05, 0.05);
  hard.size = Vec3(0.1, 0.2, 0.2);
  hard.youngs_modulus = 4e4;
  desc.material.regions.push_back(hard);
  return desc;
}

class Layers : public testing::TestWithParam<std::tuple<std::string, std::string>> {};
std::vector<std::string> on_tets() {
  std::vector<std::string> names;
  for (const soft::ModelRow& row : soft::models())
    if (row.tets) names.push_back(row.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Table, Layers,
                         testing::Combine(testing::ValuesIn(on_tets()), testing::Values("tet4", "tet10")),
                         [](const auto& row) {
                           return std::get<0>(row.param) + "_" + std::get<1>(row.param);
                         });

/// A small homogeneous strain stores in each layer what a body of that layer's material stores.
TEST_P(Layers, StoreWhatEachOfThemWould) {
  const auto [model, element] = GetParam();
  if (element == "tet10" && model.rfind("fem_", 0) != 0) GTEST_SKIP() << "linear elements only";
  SoftDesc desc = layered(model), soft = desc, hard = desc;
  for (SoftDesc* d : {&desc, &soft, &hard}) d->configuration.element = element;
  soft.material.regions.clear();
  hard.material.regions.clear();
  hard.material.youngs_modulus = 4e4;
  Mat3 F;
  F << 1.002, 0.001, -0.003, 0.002, 0.999, 0, 0.001, -0.002, 1.004;
  const auto energy = [&](const SoftDesc& d) {
    soft::SoftBody body(d, kuhn_anatomy({4, 2, 2}, size));
    VecX x = body.initial_state().motion.x;
    for (Eigen::Index i = 0; i < x.size(); i += 3) x.segment<3>(i) = F * x.segment<3>(i);
    return body.potential().elastic_energy(x);
  };
  const double mean = (energy(soft) + energy(hard)) / 2;
  EXPECT_NEAR(energy(desc), mean, 1e-9 * mean);
}

TEST(Regions, ASphereTakesTheElementsWhoseMiddleIsInsideAndTheLastOneHolds) {
  SoftDesc desc = layered("fem_corotational");
  RegionDesc ball;
  ball.center = Vec3(0.2, 0.05, 0.05);
  ball.radius = 0.06;
  ball.poisson_ratio = 0.4;
  desc.material.regions.push_back(ball);
  const TetMesh mesh = kuhn_box({8, 4, 4}, size);
  const soft::Materials materials = soft::make_materials(desc.material, mesh);
  std::array<int, 3> count{};
  for (std::size_t e = 0; e < mesh.tets.size(); ++e) {
    Vec3 middle = Vec3::Zero();
    for (const std::uint32_t node : mesh.tets[e]) middle += mesh.positions[node] / 4;
    const std::size_t expected = (middle - ball.center).norm() <= ball.radius ? 2 : middle.x() > 0.1;
    EXPECT_EQ(materials.kind_of(e), expected);
    ++count[expected];
  }
  for (const int n : count) EXPECT_GT(n, 0);
  EXPECT_EQ(materials.kinds[2].lame.mu, soft::lame(1e4, 0.4).mu);
  EXPECT_EQ(materials.kinds[1].lame.mu, soft::lame(4e4, 0.3).mu);
}

TEST(Regions, RefuseWhatMakesNoSense) {
  SoftDesc desc = layered("fem_corotational");
  desc.material.regions[0].poisson_ratio = 0.5;
  try {
    soft::SoftBody body(desc, kuhn_anatomy({2, 1, 1}, size));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("soft body \"stack\": region 1: poisson_ratio"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace prosector
