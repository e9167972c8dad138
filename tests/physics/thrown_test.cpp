// Two organs thrown at each other, by every kind of rung.

#include "tests/physics/thrown.h"

#include <gtest/gtest.h>

#include "server/physics/mechanics/soft/soft_body.h"

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

// Without fem_linear, which is for small rotations, and these tumble.
INSTANTIATE_TEST_SUITE_P(
    Rungs, ThrownOrgans,
    testing::Values(
        Throw{"corotational", {"fem_corotational", "implicit_euler"}, {"fem_corotational", "implicit_euler"}},
        Throw{"corotational_bdf2", {"fem_corotational", "bdf2"}, {"fem_corotational", "bdf2"}},
        Throw{"corotational_tr_bdf2", {"fem_corotational", "tr_bdf2"}, {"fem_corotational", "tr_bdf2"}},
        Throw{"corotational_explicit",
              {"fem_corotational", "symplectic_euler"},
              {"fem_corotational", "symplectic_euler"}},
        Throw{"corotational_verlet", {"fem_corotational", "verlet"}, {"fem_corotational", "verlet"}},
        Throw{"corotational_rk4", {"fem_corotational", "rk4"}, {"fem_corotational", "rk4"}},
        Throw{"stvk", {"fem_stvk", "implicit_euler"}, {"fem_stvk", "implicit_euler"}},
        Throw{"neo_hookean", {"fem_neo_hookean", "implicit_euler"}, {"fem_neo_hookean", "implicit_euler"}},
        Throw{"neo_hookean_explicit",
              {"fem_neo_hookean", "symplectic_euler"},
              {"fem_neo_hookean", "symplectic_euler"}},
        Throw{"springs", {"mass_spring", "implicit_euler"}, {"mass_spring", "implicit_euler"}},
        Throw{"springs_explicit", {"mass_spring", "symplectic_euler"}, {"mass_spring", "symplectic_euler"}},
        Throw{"xpbd", {"xpbd", "implicit_euler"}, {"xpbd", "implicit_euler"}},
        Throw{"corotational_at_xpbd", {"fem_corotational", "implicit_euler"}, {"xpbd", "implicit_euler"}},
        Throw{"explicit_at_implicit",
              {"fem_corotational", "symplectic_euler"},
              {"fem_corotational", "implicit_euler"}},
        Throw{"explicit_at_xpbd", {"fem_corotational", "symplectic_euler"}, {"xpbd", "implicit_euler"}},
        Throw{"neo_hookean_at_springs",
              {"fem_neo_hookean", "implicit_euler"},
              {"mass_spring", "implicit_euler"}}),
    [](const auto& info) { return info.param.name; });

TEST_P(ThrownOrgans, PartAsTheyWere) {
  CompileOptions compiled;
  compiled.threads = 1;
  Simulation simulation(two_livers(GetParam().left, GetParam().right, 0.05), compiled);
  const Thrown thrown =
      throw_at_each_other(simulation, 200, [&]() -> const StepReport& { return simulation.step({}); });
  ASSERT_TRUE(thrown.finite);
  EXPECT_GT(thrown.exchanged, 0.5 * simulation.soft(0).total_mass() * thrown_speed) << "they have met";
  EXPECT_LT(thrown.momentum_lost, 1e-6);
  EXPECT_LT(thrown.energy_gained, 1e-3);
  EXPECT_GT(thrown.parting, 0.1);
  EXPECT_EQ(thrown.overlap_after, 0);
  // Nothing damps them: position-based ones still swing.
  const bool swings = GetParam().left.model == "xpbd" || GetParam().right.model == "xpbd";
  EXPECT_LT(thrown.distortion_after, swings ? 4e-3 : 2e-3);
}

}  // namespace
}  // namespace prosector::test
