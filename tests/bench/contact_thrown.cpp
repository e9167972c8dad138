// Two livers collide off-centre at 2 m/s each, with every kind of model configuration. Momentum must be
// conserved, no energy gained, and the livers must separate with their shapes recovered.

#include "tests/bench/contact_run.h"
#include "tests/physics/thrown.h"

namespace prosector {
namespace {

const std::vector<std::pair<test::ThrownRung, test::ThrownRung>> pairs = {
    {{"fem_corotational", "implicit_euler"}, {"fem_corotational", "implicit_euler"}},
    {{"fem_neo_hookean", "implicit_euler"}, {"fem_neo_hookean", "implicit_euler"}},
    {{"fem_corotational", "tr_bdf2"}, {"fem_corotational", "tr_bdf2"}},
    {{"fem_corotational", "symplectic_euler"}, {"fem_corotational", "symplectic_euler"}},
    {{"mass_spring", "implicit_euler"}, {"mass_spring", "implicit_euler"}},
    {{"xpbd", "implicit_euler"}, {"xpbd", "implicit_euler"}},
    {{"fem_corotational", "implicit_euler"}, {"xpbd", "implicit_euler"}},
};

void throw_two(ContactRows& rows, const test::ThrownRung& left, const test::ThrownRung& right, double cell,
               int ticks) {
  CompileOptions options;
  options.threads = 1;
  ContactRun run(test::two_livers(left, right, cell), options);
  const test::Thrown thrown =
      test::throw_at_each_other(run.simulation(), ticks, [&]() -> const StepReport& { return run.step(); });
  const std::string setting = left.name() == right.name() ? left.name() : left.name() + " at " + right.model;
  rows.add(run, setting, {"relative momentum loss", "1", thrown.momentum_lost, 0, 1e-3},
           {{"deepest_mm", 1e3 * thrown.deepest},
            {"exchanged_Ns", thrown.exchanged},
            {"tets", tet_count(run.simulation())}});
  rows.add(run, setting, {"relative energy gain", "1", thrown.energy_gained, 0, 1e-2});
  rows.add(run, setting, {"penetration depth after 2 s", "mm", 1e3 * thrown.overlap_after, 0, 0.1});
  rows.add(run, setting, {"shape error after 2 s", "mm", 1e3 * thrown.distortion_after, 0, 2});
  rows.add(run, setting, {"separation speed", "m/s", thrown.parting, 2, 2});
}

}  // namespace

void thrown_case(ContactRows& rows, bool quick) {
  for (const auto& [left, right] : pairs) {
    throw_two(rows, left, right, quick ? 0.05 : 0.025, quick ? 30 : 130);
    if (quick) return;
  }
}

}  // namespace prosector
