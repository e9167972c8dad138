// Which rung is chosen, over tables that are made up: nothing here takes time.

#include <gtest/gtest.h>

#include <cmath>

#include "common/anatomy/kuhn_box.h"
#include "common/error.h"
#include "tests/calibration/tables.h"

namespace prosector {
namespace {

using test::made_up_table;

SoftDesc needing(double accuracy_percent, double budget_ms) {
  SoftDesc desc;
  desc.name = "liver";
  desc.choice.accuracy.value = accuracy_percent;
  desc.choice.budget.value = budget_ms;
  return desc;
}

/// Of a beam as the table's own.
constexpr double cell = 0.05;
BodyGeometry beam() {
  return geometry_of(kuhn_box({0.4, 0.1, 0.1}, 8, 2, 2));
}

Choice choose(const SoftDesc& desc) {
  return choose_rung(desc, made_up_table(desc), beam(), cell);
}

TEST(LogInterpolate, IsExactOnPowerLawsAndBoundedBeyond) {
  const std::vector<double> xs = {1, 2, 8}, ys = {5, 20, 320};  // 5x²
  EXPECT_NEAR(log_interpolate(xs, ys, 4, 0, 9), 80, 1e-9);
  EXPECT_NEAR(log_interpolate(xs, ys, 16, 0, 9), 1280, 1e-6);
  EXPECT_NEAR(log_interpolate(xs, ys, 0.5, 0, 9), 1.25, 1e-9);
  EXPECT_NEAR(log_interpolate(xs, ys, 16, 0, 1), 640, 1e-6) << "the rate is held within its bounds";
  EXPECT_NEAR(log_interpolate({2}, {6}, 4, 1, 2), 12, 1e-12);
}

TEST(BodyGeometry, CountsAndMeasures) {
  const BodyGeometry g = beam();
  EXPECT_EQ(g.elements, 6 * 8 * 2 * 2);
  EXPECT_NEAR(g.volume, 0.004, 1e-12);
  EXPECT_NEAR(g.thickness, 4 * 0.004 / 0.18, 1e-12);
  BodyGeometry finer = g;
  finer.elements *= 8;
  EXPECT_NEAR(finer.fineness() / g.fineness(), 2, 1e-12);
}

TEST(RungTable, AFinerMeshIsNeverWorseAndNoBetterThanMeasured) {
  const SoftDesc desc = needing(2, 0);
  const RungTable table = made_up_table(desc);
  for (const Rung& rung : candidates(desc)) {
    double error = 1e9, ms = 0, finest = 0;
    for (double elements = 10; elements < 1e6; elements *= 1.3) {
      BodyGeometry body = beam();
      body.elements = elements;
      const auto p = table.prospect(rung, 0.45, body, false);
      ASSERT_TRUE(p);
      EXPECT_LE(p->error, error * (1 + 1e-12)) << rung.name() << " " << elements;
      EXPECT_GT(p->ms, ms);
      error = p->error;
      ms = p->ms;
      finest = elements;
    }
    for (const RungTable::Row& row : table.rows())
      if (row.trial.rung == rung) {
        EXPECT_GE(error, 0.9e-4) << finest;
      }
  }
}

TEST(RungTable, ErrorsThatCancelByChanceDontCount) {
  RungTable table;
  const Rung rung{"mass_spring", "implicit_euler", "cg"};
  const auto add = [&](unsigned cells, double error) {
    RungFigures f{6. * cells * cells * cells / 16, tissue_sag(0.45) * (1 + error), 0, 10, 1. * cells};
    table.add({rung, 0.45, cells}, f);
  };
  add(8, -0.3);
  add(12, 0.001);  // stiff by locking, soft by its springs
  add(16, 0.15);
  BodyGeometry body = beam();
  body.elements = 648;
  EXPECT_NEAR(table.prospect(rung, 0.45, body, false)->error, 0.15, 1e-9);
}

TEST(RungTable, CostIsCarriedOverWithTheElements) {
  const SoftDesc desc = needing(2, 0);
  const RungTable table = made_up_table(desc);
  const Rung rung = candidates(desc).back();
  BodyGeometry body = beam();
  body.elements = 6000;
  const double once = table.prospect(rung, 0.45, body, false)->ms;
  body.elements = 12000;
  EXPECT_NEAR(table.prospect(rung, 0.45, body, false)->ms / once, 2, 1e-9) << "made up in proportion";
}

TEST(ChooseRung, IsTheCheapestThatIsGoodEnough) {
  double last_ms = 1e9;
  for (const double percent : {0.5, 1.0, 2.0, 5.0, 10.0, 30.0}) {
    const SoftDesc desc = needing(percent, 0);
    const Choice choice = choose(desc);
    if (percent >= 2) {
      EXPECT_TRUE(choice.good_enough) << percent;
      EXPECT_LE(100 * choice.expected.error, percent);
    }
    EXPECT_LE(choice.expected.ms, last_ms * (1 + 1e-12)) << "more error allowed must not cost more";
    last_ms = choice.expected.ms;
  }
  EXPECT_EQ(choose(needing(30, 0)).rung.model, "xpbd") << "20 % off by itself, and the cheapest";
  EXPECT_EQ(choose(needing(2, 0)).rung.element, "tet10");
}

TEST(ChooseRung, IsTheBestWithinABudget) {
  double last_error = 1e9;
  for (const double ms : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    const Choice choice = choose(needing(0, ms));
    EXPECT_TRUE(choice.good_enough) << ms;
    EXPECT_LE(choice.expected.ms, ms);
    EXPECT_LE(choice.expected.error, last_error * (1 + 1e-12)) << "more time must not err more";
    last_error = choice.expected.error;
  }
}

TEST(ChooseRung, SaysByHowMuchItMisses) {
  SoftDesc desc = needing(0.01, 0);
  Choice choice = choose(desc);
  EXPECT_FALSE(choice.good_enough);
  for (const Rung& rung : candidates(desc)) {
    BodyGeometry finest = beam();
    finest.elements = 1e6;
    EXPECT_LE(choice.expected.error,
              made_up_table(desc).prospect(rung, 0.45, finest, false)->error * (1 + 1e-9));
  }
  EXPECT_NE(explain(choice, desc).find("the most accurate one misses"), std::string::npos)
      << explain(choice, desc);
  desc = needing(0, 1e-3);
  choice = choose(desc);
  EXPECT_FALSE(choice.good_enough);
  EXPECT_NE(explain(choice, desc).find("exceeds the budget by"), std::string::npos) << explain(choice, desc);
}

TEST(ChooseRung, KeepsWhatTheSceneFixed) {
  SoftDesc desc = needing(5, 0);
  desc.configuration.model = "fem_linear";
  desc.configuration.element = "tet4";
  desc.configuration.solver = "direct";
  desc.choice.fixed = {.model = true, .element = true, .integrator = false, .solver = true, .cell = true};
  const Choice choice = choose(desc);
  EXPECT_EQ(choice.rung.model, "fem_linear");
  EXPECT_EQ(choice.rung.element, "tet4");
  EXPECT_EQ(choice.rung.solver, "direct");
  EXPECT_EQ(choice.cell, cell);
}

TEST(ChooseRung, RefusesWhatNothingGoesWith) {
  SoftDesc desc = needing(5, 0);
  desc.configuration.model = "xpbd";
  desc.configuration.element = "tet10";
  desc.choice.fixed.model = desc.choice.fixed.element = true;
  EXPECT_THROW(candidates(desc), InputError);
  desc.configuration.model = "jelly";
  EXPECT_THROW(candidates(desc), InputError);
}

TEST(ChooseRung, LeavesOutModelsThatDoNotKnowTheMaterial) {
  SoftDesc desc = needing(5, 0);
  desc.material.relaxation.push_back({});
  for (const Rung& rung : candidates(desc)) EXPECT_TRUE(rung.model.starts_with("fem_")) << rung.model;
}

TEST(ChooseRung, SaysThatARatioWasNotMeasured) {
  SoftDesc desc = needing(5, 0);
  desc.material.poisson_ratio = 0.4995;
  EXPECT_NE(explain(choose(desc), desc).find("expect a larger error"), std::string::npos);
  desc.material.poisson_ratio = 0.499;
  EXPECT_EQ(explain(choose(desc), desc).find("expect a larger error"), std::string::npos);
}

TEST(ChooseRung, MeasuresAtTheNextLargerRatio) {
  const std::pair<double, double> cases[] = {{0, 0.3},     {0.3, 0.3},   {0.31, 0.45},   {0.45, 0.45},
                                             {0.46, 0.49}, {0.49, 0.49}, {0.495, 0.499}, {0.4999, 0.499}};
  for (const auto& [ratio, measured] : cases) {
    SoftDesc desc = needing(5, 0);
    desc.material.poisson_ratio = ratio;
    for (const RungTrial& trial : trials_for(desc)) EXPECT_EQ(trial.poisson_ratio, measured) << ratio;
  }
}

}  // namespace
}  // namespace prosector
