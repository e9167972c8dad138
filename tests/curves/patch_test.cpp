// Pieces of surfaces against closed forms.

#include "common/curves/patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/curves/conic.h"
#include "common/error.h"

namespace prosector {
namespace {

/// An eighth of the unit sphere: two quarter circles multiplied (Piegl & Tiller, ch. 8).
NurbsSurface octant() {
  const double w = std::sqrt(0.5);
  std::vector<Vec3> points;
  std::vector<double> weights;
  const Vec3 quarter[3] = {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}};  // (out, up)
  for (const Vec3& up : quarter)
    for (const Vec3& around : quarter) {
      points.emplace_back(up.x() * around.x(), up.y(), up.x() * around.y());
      weights.push_back((&up == quarter + 1 ? w : 1) * (&around == quarter + 1 ? w : 1));
    }
  return {{2, bezier_knots(2)}, {2, bezier_knots(2)}, 3, points, weights};
}

void expect_derivatives(const Patch& patch) {
  constexpr double h = 1e-6;
  for (const double u : {0.21, 0.68})
    for (const double v : {0.17, 0.55}) {
      const PatchPoint p = patch.evaluate(u, v);
      EXPECT_LT(((patch.evaluate(u + h, v).x - patch.evaluate(u - h, v).x) / (2 * h) - p.u).norm(), 1e-8);
      EXPECT_LT(((patch.evaluate(u, v + h).x - patch.evaluate(u, v - h).x) / (2 * h) - p.v).norm(), 1e-8);
    }
}

TEST(Patch, RationalTensorProductMeetsTheSphere) {
  const NurbsSurface sphere = octant();
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; j <= 20; ++j) EXPECT_NEAR(sphere.evaluate(i / 20.0, j / 20.0).x.norm(), 1, 1e-15);
  expect_derivatives(sphere);
}

std::array<NurbsCurve, 4> sides() {
  return {NurbsCurve::bezier({{0, 0, 0}, {0.3, 0.4, 0}, {0.7, -0.2, 0.1}, {1, 0, 0}}),
          NurbsCurve(2, {0, 0, 0, 0.4, 2, 2, 2}, {{0, 0.1, 1}, {0.2, 0.5, 1}, {0.8, 0.5, 1.2}, {1, 0.2, 1}}),
          NurbsCurve::bezier({{0, 0, 0}, {-0.2, 0.2, 0.5}, {0, 0.1, 1}}, {1, 2, 1}),
          NurbsCurve::bezier({{1, 0, 0}, {1, 0.2, 1}})};
}

TEST(Patch, CoonsInterpolatesItsFourSides) {
  const auto [low, high, left, right] = sides();
  const CoonsPatch coons(sides());
  for (int i = 0; i <= 50; ++i) {
    const double s = i / 50.0;
    EXPECT_LT((coons.evaluate(s, 0).x - low.at(s)).norm(), 1e-15);
    EXPECT_LT((coons.evaluate(s, 1).x - high.at(2 * s)).norm(), 1e-15);
    EXPECT_LT((coons.evaluate(0, s).x - left.at(s)).norm(), 1e-15);
    EXPECT_LT((coons.evaluate(1, s).x - right.at(s)).norm(), 1e-15);
  }
  expect_derivatives(coons);
  EXPECT_EQ(coons.seams()[0], (std::vector<double>{0, 0.2, 1}));
}

TEST(Patch, RefusesWhatIsNone) {
  std::array<NurbsCurve, 4> open = sides();
  open[3] = NurbsCurve::bezier({{1, 0, 0}, {1, 0.3, 1}});
  try {
    CoonsPatch coons(open);
    FAIL() << "took sides that don't meet";
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "sides 2 and 4 of a Coons patch are 0.1 m apart at the corner u = 1, v = 1; they must meet there");
  }
  const std::vector<Vec3> points(7, Vec3::Zero());
  EXPECT_THROW(NurbsSurface({2, bezier_knots(2)}, {2, bezier_knots(2)}, 3, points), InputError);
  EXPECT_THROW(NurbsSurface({2, bezier_knots(2)}, {2, bezier_knots(2)}, 0, points), InputError);
  EXPECT_THROW(NurbsSurface({2, bezier_knots(2)}, {2, bezier_knots(2)}, 1, points), InputError);
}

}  // namespace
}  // namespace prosector
