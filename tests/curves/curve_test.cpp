// Curves against their closed forms and against each other's algorithms.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "common/curves/conic.h"
#include "common/error.h"

namespace prosector {
namespace {

NurbsCurve wild(int degree, std::size_t points, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> any(-1, 1), weight(0.2, 3);
  std::vector<Vec3> x;
  std::vector<double> w;
  for (std::size_t k = 0; k < points; ++k) {
    x.emplace_back(any(random), any(random), any(random));
    w.push_back(weight(random));
  }
  return {degree, clamped_knots(points, degree), x, w};
}

TEST(Basis, BernsteinPolynomialsAreAPartitionOfUnity) {
  for (int degree = 1; degree <= max_degree; ++degree) {
    const std::vector<double> knots = bezier_knots(degree);
    for (int i = 0; i <= 20; ++i) {
      const double u = i / 20.0;
      const BasisDerivatives n = basis_derivatives(knots, static_cast<std::size_t>(degree), degree, u);
      double sum = 0, slope = 0, curvature = 0;
      for (int k = 0; k <= degree; ++k) {
        const double binomial =
            std::round(std::exp(std::lgamma(degree + 1) - std::lgamma(k + 1) - std::lgamma(degree - k + 1)));
        const double bernstein = binomial * std::pow(u, k) * std::pow(1 - u, degree - k);
        EXPECT_NEAR(n.order[0][static_cast<std::size_t>(k)], bernstein, 1e-14);
        EXPECT_GE(n.order[0][static_cast<std::size_t>(k)], 0);
        sum += n.order[0][static_cast<std::size_t>(k)];
        slope += n.order[1][static_cast<std::size_t>(k)];
        curvature += n.order[2][static_cast<std::size_t>(k)];
      }
      EXPECT_NEAR(sum, 1, 1e-15);
      EXPECT_NEAR(slope, 0, 1e-12);
      EXPECT_NEAR(curvature, 0, 1e-10);
    }
  }
}

TEST(Curve, DeBoorOnBezierKnotsIsDeCasteljau) {
  for (int degree = 1; degree <= max_degree; ++degree) {
    const NurbsCurve curve = wild(degree, static_cast<std::size_t>(degree) + 1, 3);
    const BezierPiece piece{{curve.points().begin(), curve.points().end()}, 0, 1};
    for (int i = 0; i <= 16; ++i)
      EXPECT_LT((curve.at(i / 16.0) - piece.at(i / 16.0)).norm(), 2e-15) << degree;
  }
}

TEST(Curve, ItsBezierPiecesAndTheirHalvesAreTheCurve) {
  // Ends that aren't met, and a knot twice.
  const NurbsCurve open(2, {0, 1, 2, 3, 3, 4, 5, 6}, {{0, 0, 0}, {1, 2, 0}, {2, 0, 1}, {3, 1, 0}, {4, 0, 0}});
  for (const NurbsCurve& curve : {wild(3, 9, 1), wild(5, 8, 2), open}) {
    double from = curve.begin();
    for (const BezierPiece& piece : bezier_pieces(curve)) {
      EXPECT_EQ(piece.from, from);
      from = piece.to;
      for (const BezierPiece& half : piece.halves())
        for (const double s : {0.0, 0.3, 1.0})
          EXPECT_LT((half.at(s) - curve.at(half.from + s * (half.to - half.from))).norm(), 1e-14);
    }
    EXPECT_EQ(from, curve.end());
  }
}

TEST(Curve, DerivativesAreDifferenceQuotients) {
  const NurbsCurve curve = wild(4, 9, 5);
  constexpr double h = 1e-5;
  for (const double u : {0.13, 0.37, 0.71, 0.93}) {
    const CurvePoint p = curve.evaluate(u);
    const Vec3 before = curve.at(u - h), after = curve.at(u + h);
    EXPECT_LT(((after - before) / (2 * h) - p.first).norm(), 1e-6 * p.second.norm());
    EXPECT_LT(((after - 2 * p.x + before) / (h * h) - p.second).norm(), 1e-3 * p.second.norm());
  }
}

TEST(Conic, CircleIsRoundToTheLastBits) {
  const NurbsCurve circle = ellipse_arc(1, 1, 0, 2 * M_PI);
  for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(circle.at(i / 1000.0).norm(), 1, 1e-15);
  EXPECT_EQ(circle.at(0), circle.at(1));
}

TEST(Conic, ArcsSatisfyTheirEquationsAndEndWhereAsked) {
  constexpr double a = 0.3, b = 0.2;
  const NurbsCurve ellipse = ellipse_arc(a, b, -0.4, 3.9), hyperbola = hyperbola_arc(a, b, -1.5, 0.7);
  const NurbsCurve parabola = parabola_arc(a, -2, 1);
  for (int i = 0; i <= 200; ++i) {
    const double u = i / 200.0;
    const Vec3 e = ellipse.at(u), h = hyperbola.at(u), p = parabola.at(u);
    EXPECT_NEAR(e.x() * e.x() / (a * a) + e.y() * e.y() / (b * b), 1, 2e-15);
    EXPECT_NEAR(h.x() * h.x() / (a * a) - h.y() * h.y() / (b * b), 1, 1e-14);
    EXPECT_NEAR(p.y() * p.y(), 4 * a * p.x(), 2e-15);
  }
  EXPECT_LT((ellipse.at(0) - Vec3(a * std::cos(-0.4), b * std::sin(-0.4), 0)).norm(), 1e-15);
  EXPECT_LT((ellipse.at(1) - Vec3(a * std::cos(3.9), b * std::sin(3.9), 0)).norm(), 1e-15);
  EXPECT_LT((hyperbola.at(1) - Vec3(a * std::cosh(0.7), b * std::sinh(0.7), 0)).norm(), 1e-15);
  EXPECT_LT((parabola.at(0) - Vec3(4 * a, -4 * a, 0)).norm(), 1e-15);
}

TEST(Curve, RefusesWhatIsNone) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}};
  const auto says = [&](const auto& make) -> std::string {
    try {
      make();
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing";
  };
  const auto knots = [&](std::vector<double> k) { return says([&] { NurbsCurve(2, std::move(k), x); }); };
  EXPECT_EQ(knots({0, 0, 0, 0.5, 1, 1, 1}), "nothing");
  EXPECT_EQ(knots({0, 0, 0, 0.5, 1, 1}), "6 knots are given, but a curve of 4 points and degree 2 needs 7");
  EXPECT_EQ(knots({0, 0, 0, 0.5, 0.4, 1, 1}),
            "knot 5 is 0.4, which is below the knot before it, 0.5; knots must not decrease");
  EXPECT_EQ(knots({0, 0, 0, NAN, 1, 1, 1}), "knot 4 is not a finite number");
  EXPECT_EQ(knots({0, 0, 0, 0, 1, 1, 1}), "knots 2 to 4 are all 0: at most 2 within the curve may be equal");
  EXPECT_EQ(knots({-1, 0, 0, 0, 0, 0, 1}).substr(0, 20), "knots 2 to 4 are all");
  EXPECT_EQ(says([&] { NurbsCurve(4, clamped_knots(5, 4), x); }),
            "4 control points are too few for degree 4: it needs 5 at least");
  EXPECT_EQ(says([&] { NurbsCurve(0, {}, x); }), "degree 0: must be 1 to 9");
  EXPECT_EQ(says([&] { NurbsCurve::bezier({{0, NAN, 0}, {1, 0, 0}}); }), "point 1 is not finite");
  EXPECT_EQ(says([&] {
              NurbsCurve::bezier({{0, 0, 0}, {1, 0, 0}}, {1, -1});
            }),
            "weight 2 is -1: must be above 0 and finite");
  EXPECT_EQ(says([&] {
              NurbsCurve::bezier({{0, 0, 0}});
            }),
            "a bezier curve has 1 points: it must have 2 to 10");
  EXPECT_NE(says([&] { ellipse_arc(1, 0, 0, 1); }), "nothing");
  EXPECT_NE(says([&] { hyperbola_arc(1, 1, 2, 2); }), "nothing");
}

}  // namespace
}  // namespace prosector
