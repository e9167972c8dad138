// Two organs thrown at each other, by every kind of rung.

#include "tests/physics/thrown.h"

#include <gtest/gtest.h>

#include "server/physics/soft/soft_body.h"

namespace prosector::test {
namespace {

struct Throw {
  const char* name;
  ThrownRung left, right;
};

void PrintTo(const Throw& t, std::ostream* out) {
  *out << t.name;
}

class ThrownOrgans : public testing::TestWithParam<Throw> {};

// The other rungs pass through each other at this speed and resolution, or gain energy: docs/contact.md.
INSTANTIATE_TEST_SUITE_P(
    Rungs, ThrownOrgans,
    testing::Values(
        Throw{"neo_hookean", {"fem_neo_hookean", "implicit_euler"}, {"fem_neo_hookean", "implicit_euler"}},
        Throw{"springs", {"mass_spring", "implicit_euler"}, {"mass_spring", "implicit_euler"}}),
    [](const auto& info) { return info.param.name; });

TEST_P(ThrownOrgans, PartAsTheyWere) {
  CompileOptions compiled;
  compiled.threads = 1;
  Simulation simulation(two_livers(GetParam().left, GetParam().right, 0.05), compiled);
  const Thrown thrown =
      throw_at_each_other(simulation, 130, [&]() -> const StepReport& { return simulation.step({}); });
  ASSERT_TRUE(thrown.finite);
  EXPECT_GT(thrown.exchanged, 0.5 * simulation.soft(0).total_mass() * thrown_speed) << "they have met";
  EXPECT_LT(thrown.momentum_lost, 1e-3);
  EXPECT_LT(thrown.energy_gained, 0.01);
  EXPECT_GT(thrown.parting, 0.1);
  EXPECT_EQ(thrown.overlap_after, 0);
  EXPECT_LT(thrown.distortion_after, 2e-3);
}

}  // namespace
}  // namespace prosector::test
