// Real measurements, small ones: figures that don't depend on how busy the machine is.

#include "server/calibration/rung_meter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "server/calibration/bend_reference.h"
#include "server/calibration/rung_table.h"

namespace prosector {
namespace {

Rung rung(const std::string& element, const std::string& solver, int newton, int iterations,
          double tolerance) {
  Rung out{"fem_corotational", "implicit_euler", solver};
  out.element = element;
  out.newton_iterations = newton;
  out.solver_iterations = iterations;
  out.solver_tolerance = tolerance;
  return out;
}

TEST(RungMeter, SettledShapesApproachTheContinuum) {
  RungMeter meter;
  const double right = *continuum_sag("fem_corotational", 0.45);
  const Rung thorough = rung("tet4", "multigrid", 3, 30, 1e-3);
  const double coarse = meter.measure({thorough, 0.45, 4}).settled_sag / right - 1;
  const double fine = meter.measure({thorough, 0.45, 8}).settled_sag / right - 1;
  const double quadratic =
      meter.measure({rung("tet10", "multigrid", 3, 30, 1e-3), 0.45, 8}).settled_sag / right - 1;
  EXPECT_LT(coarse, fine) << "linear tetrahedra lock: too stiff, and less so on a finer mesh";
  EXPECT_LT(fine, -0.1);
  EXPECT_LT(std::abs(quadratic), 0.05);
}

/// Who asks for nearly incompressible tissue must not get what locks.
TEST(RungMeter, SeesLinearTetrahedraLockAndQuadraticOnesNot) {
  RungMeter meter;
  for (const double ratio : {0.49, 0.499}) {
    const double right = tissue_sag(ratio);
    const auto error = [&](const char* element) {
      Rung quick = rung(element, "multigrid", 1, 10, 1e-2);
      quick.model = "fem_neo_hookean";
      return meter.measure({quick, ratio, 8}).settled_sag / right - 1;
    };
    EXPECT_LT(error("tet4"), -0.7) << ratio;
    EXPECT_LT(std::abs(error("tet10")), 0.01) << ratio;
  }
}

TEST(RungMeter, LessEffortDrifts) {
  RungMeter meter;
  const double quick = meter.measure({rung("tet4", "cg", 1, 5, 1e-2), 0.45, 8}).drift;
  const double thorough = meter.measure({rung("tet4", "multigrid", 5, 100, 1e-5), 0.45, 8}).drift;
  EXPECT_LT(thorough, 2e-3);
  EXPECT_GT(quick, 5 * thorough);
}

TEST(RungMeter, ErrorsAndIterationsAreTheSameEachTime) {
  const RungTrial trial{rung("tet4", "cg", 3, 60, 1e-3), 0.3, 8};
  const RungFigures a = RungMeter().measure(trial), b = RungMeter().measure(trial);
  EXPECT_EQ(a.settled_sag, b.settled_sag);
  EXPECT_EQ(a.drift, b.drift);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.elements, 192);
  EXPECT_GT(a.ms, 0);
}

/// The model that carries a cost over to another number of elements, held against counted work: elements
/// times iterations of solves to the end, extrapolated by a power between linear and 4/3.
TEST(RungMeter, WorkGrowsAsTheScalingModelSays) {
  RungMeter meter;
  for (const char* solver : {"cg", "multigrid"}) {
    const Rung thorough = rung("tet4", solver, 3, 2000, 1e-3);
    std::vector<double> elements, work;
    for (const unsigned cells : {8u, 12u, 16u}) {
      const RungFigures f = meter.measure({thorough, 0.45, cells});
      elements.push_back(f.elements);
      work.push_back(f.elements * f.iterations);
    }
    const double expected =
        log_interpolate({elements[0], elements[1]}, {work[0], work[1]}, elements[2], 1, 4. / 3);
    EXPECT_NEAR(work[2] / expected, 1, 0.25) << solver;
  }
}

TEST(RungMeter, PositionBasedModelsAreMeasuredByTheirOwnMotion) {
  RungMeter meter;
  Rung xpbd{"xpbd", "implicit_euler", "cg"};
  xpbd.substeps = 20;
  const RungFigures f = meter.measure({xpbd, 0.45, 8});
  EXPECT_EQ(f.elements, 192);
  EXPECT_EQ(f.iterations > 0, f.drift > 0) << "iterations are a fallback's, which counts against it";
  EXPECT_GT(f.settled_sag, 0.02);
}

}  // namespace
}  // namespace prosector
