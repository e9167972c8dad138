// What curves and patches become: near enough to the truth, closed, and no finer than needed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/curves/conic.h"
#include "common/curves/flatten.h"
#include "common/curves/patch_mesh.h"
#include "common/curves/tube.h"
#include "common/error.h"

namespace prosector {
namespace {

double distance_to_segment(const Vec3& x, const Vec3& a, const Vec3& b) {
  const double share = std::clamp((b - a).dot(x - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (x - a - share * (b - a)).norm();
}

double distance_to_mesh(const Vec3& x, const TriangleMesh& mesh) {
  double least = 1e9;
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const Vec3 n = (b - a).cross(c - a);
    const double off = std::abs(n.dot(x - a)) / n.norm();
    if (off >= least) continue;
    const bool over = n.dot((b - a).cross(x - a)) >= 0 && n.dot((c - b).cross(x - b)) >= 0 &&
                      n.dot((a - c).cross(x - c)) >= 0;
    least = std::min(least, over ? off
                                 : std::min({distance_to_segment(x, a, b), distance_to_segment(x, b, c),
                                             distance_to_segment(x, c, a)}));
  }
  return least;
}

/// Each edge lies between two triangles that run along it in opposite directions.
void expect_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

double volume_of(const TriangleMesh& mesh) {
  double six = 0;
  for (const auto& t : mesh.triangles)
    six += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]]));
  return six / 6;
}

NurbsCurve vessel() {
  return {3,
          clamped_knots(7, 3),
          {{0, 0, 0},
           {0.1, 0, 0},
           {0.1, 0.08, 0},
           {0.04, 0.1, 0.05},
           {0.1, 0.1, 0.12},
           {0.2, 0.05, 0.1},
           {0.2, 0, 0.2}},
          {1, 1, 2, 0.5, 1, 1, 1}};
}

TEST(Flatten, StaysWithinTheToleranceAndIsNotMuchFinerThanNeeded) {
  for (const double tolerance : {1e-3, 1e-4, 1e-5}) {
    const NurbsCurve curve = vessel();
    const std::vector<double> ends = flatten(curve, tolerance, M_PI);
    double worst = 0;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k)
      for (const double s : {0.1, 0.3, 0.5, 0.7, 0.9})
        worst = std::max(worst, distance_to_segment(curve.at(ends[k] + s * (ends[k + 1] - ends[k])),
                                                    curve.at(ends[k]), curve.at(ends[k + 1])));
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, tolerance / 8);
  }
  const double radius = 0.05, tolerance = 1e-4;
  const std::size_t needed = static_cast<std::size_t>(std::ceil(M_PI / std::acos(1 - tolerance / radius)));
  EXPECT_LE(flatten(ellipse_arc(radius, radius, 0, 2 * M_PI), tolerance, M_PI).size(), 4 * needed);
}

TEST(Flatten, RefusesWhatWouldTakeTooManyPieces) {
  EXPECT_THROW(flatten(ellipse_arc(1, 1, 0, 2 * M_PI), 1e-14, M_PI), InputError);
}

// Along a helix of torsion τ the sides turn by −τ a metre against the Frenet frame.
TEST(Frames, DoubleReflectionIsOfFourthOrderAlongAHelix) {
  constexpr double r = 0.1, h = 0.05, l = r * r + h * h, turns = 4 * M_PI;
  const auto error_with = [&](int steps) {
    std::vector<Vec3> places, tangents;
    for (int k = 0; k <= steps; ++k) {
      const double t = turns * k / steps;
      places.emplace_back(r * std::cos(t), r * std::sin(t), h * t);
      tangents.push_back(Vec3(-r * std::sin(t), r * std::cos(t), h).normalized());
    }
    const std::vector<Vec3> sides = rotation_minimising_sides(places, tangents, {-1, 0, 0});
    const Vec3 normal(-std::cos(turns), -std::sin(turns), 0), binormal = tangents.back().cross(normal);
    const double angle = -h / l * std::sqrt(l) * turns;
    return (sides.back() - (std::cos(angle) * normal + std::sin(angle) * binormal)).norm();
  };
  const double coarse = error_with(60), fine = error_with(120);
  EXPECT_LT(fine, 1e-5);
  EXPECT_GT(coarse / fine, 12);
  EXPECT_LT(coarse / fine, 20);
}

TEST(Tube, IsClosedAndWithinTheTolerance) {
  for (const double tolerance : {5e-4, 1e-4}) {
    constexpr double radius = 4e-3;
    const NurbsCurve curve = vessel();
    const TriangleMesh tube = tube_around(curve, 2 * radius, tolerance);
    expect_closed(tube);
    double worst = 0;
    for (int i = 0; i <= 60; ++i) {
      const CurvePoint p = curve.evaluate(i / 60.0);
      const Vec3 across = p.first.cross(Vec3(0.3, 0.5, 0.8)).normalized(),
                 other = p.first.normalized().cross(across);
      for (int k = 0; k < 7; ++k)
        worst = std::max(worst,
                         distance_to_mesh(p.x + radius * (std::cos(k) * across + std::sin(k) * other), tube));
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_GT(worst, tolerance / 20);
  }
}

TEST(Tube, HasAStraightOnesVolume) {
  const NurbsCurve line = NurbsCurve::bezier({{0, 0, 0}, {0, 0.3, 0}});
  const TriangleMesh tube = tube_around(line, 0.02, 1e-5);
  EXPECT_NEAR(volume_of(tube), M_PI * 1e-4 * 0.3, 0.002 * M_PI * 1e-4 * 0.3);
  const double sides = std::ceil(M_PI / std::acos(1 - 1e-5 / 3 / 0.01));
  EXPECT_EQ(static_cast<double>(tube.positions.size()), 2 * sides + 2) << "two rings and two middles";
}

// Pappus: the section's area times its middle's way. An ellipse's frame comes back as it left, a knot's does
// not.
TEST(Tube, ThatClosesIsARing) {
  const TriangleMesh ring = tube_around(ellipse_arc(0.05, 0.05, 0, 2 * M_PI), 0.01, 1e-5);
  expect_closed(ring);
  EXPECT_NEAR(volume_of(ring), M_PI * 25e-6 * 2 * M_PI * 0.05, 0.01 * M_PI * 25e-6 * 2 * M_PI * 0.05);
  const auto euler = [](const TriangleMesh& m) {
    return static_cast<long>(m.positions.size()) - static_cast<long>(m.triangles.size()) / 2;
  };
  EXPECT_EQ(euler(ring), 0);
  std::vector<Vec3> knot;  // a closed cubic through space, its first points repeated
  for (const int k : {0, 1, 2, 3, 4, 5, 6, 0, 1, 2})
    knot.emplace_back(0.1 * std::cos(2 * M_PI * k / 7), 0.1 * std::sin(2 * M_PI * k / 7),
                      k % 2 == 0 ? 0.03 : -0.03);
  std::vector<double> knots;
  for (int k = 0; k < 14; ++k) knots.push_back(k);
  const TriangleMesh twisted = tube_around({3, knots, knot}, 0.01, 1e-4);
  expect_closed(twisted);
  EXPECT_EQ(euler(twisted), 0);
  EXPECT_GT(volume_of(twisted), 0);
}

TEST(Tube, OfWhatHasNoLengthIsRefused) {
  EXPECT_THROW(tube_around(NurbsCurve::bezier({{1, 0, 0}, {1, 0, 0}}), 0.01, 1e-4), InputError);
  // Coinciding control points: no derivative at the ends, but a direction.
  const TriangleMesh tube =
      tube_around(NurbsCurve::bezier({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}), 0.01, 1e-4);
  for (const Vec3& x : tube.positions) EXPECT_TRUE(is_finite(x));
}

TEST(Tube, PlacesAlongACurveAreEquallyFarApart) {
  const std::vector<Vec3> places = equidistant_points(vessel(), 0.01);
  double least = 1, most = 0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    least = std::min(least, (places[k + 1] - places[k]).norm());
    most = std::max(most, (places[k + 1] - places[k]).norm());
  }
  EXPECT_GT(least, 0.0095);
  EXPECT_LT(most, 0.0105);
}

TEST(Slab, IsClosedAndItsFacesWithinTheTolerance) {
  // A quarter of a cylinder, rational across.
  const double w = std::sqrt(0.5), r = 0.05, h = 1e-3, tolerance = 1e-4;
  const NurbsSurface quarter(
      {2, bezier_knots(2)}, {1, bezier_knots(1)}, 3,
      std::vector<Vec3>{{r, 0, 0}, {r, r, 0}, {0, r, 0}, {r, 0, 0.1}, {r, r, 0.1}, {0, r, 0.1}},
      {1, w, 1, 1, w, 1});
  const TriangleMesh slab = slab_mesh(quarter, 2 * h, tolerance);
  expect_closed(slab);
  double worst = 0;
  for (int i = 0; i <= 40; ++i)
    for (const double v : {0.0, 0.31, 0.77}) {
      const Vec3 x = quarter.evaluate(i / 40.0, v).x;
      const Vec3 out = Vec3(x.x(), x.y(), 0).normalized();
      worst = std::max({worst, distance_to_mesh(x + h * out, slab), distance_to_mesh(x - h * out, slab)});
    }
  EXPECT_LE(worst, tolerance);
  EXPECT_GT(worst, tolerance / 10);
  const double true_volume = M_PI / 4 * ((r + h) * (r + h) - (r - h) * (r - h)) * 0.1;
  EXPECT_NEAR(volume_of(slab), true_volume, 0.01 * true_volume);
}

TEST(Slab, OverACoonsPatchIsWithinTheTolerance) {
  const CoonsPatch coons({NurbsCurve::bezier({{0, 0, 0}, {0.03, 0.04, 0}, {0.07, -0.02, 0.01}, {0.1, 0, 0}}),
                          NurbsCurve::bezier({{0, 0.01, 0.1}, {0.05, 0.08, 0.1}, {0.1, 0.02, 0.1}}),
                          NurbsCurve::bezier({{0, 0, 0}, {-0.02, 0.02, 0.05}, {0, 0.01, 0.1}}),
                          NurbsCurve::bezier({{0.1, 0, 0}, {0.1, 0.02, 0.1}})});
  for (const double tolerance : {1e-3, 2e-4}) {
    const TriangleMesh slab = slab_mesh(coons, 1e-3, tolerance);
    expect_closed(slab);
    double worst = 0;
    for (int i = 1; i < 20; ++i)
      for (int j = 1; j < 20; ++j) {
        const PatchPoint p = coons.evaluate(i / 20.0, j / 20.0);
        worst = std::max(worst, distance_to_mesh(p.x + 5e-4 * p.u.cross(p.v).normalized(), slab));
      }
    EXPECT_LE(worst, tolerance);
  }
  EXPECT_THROW(refine_grid(coons, 1e-9), InputError);
}

// A sphere's lower half, revolved: closed around, with a pole.
TEST(Slab, OfARevolvedCurveIsASeamlessBowl) {
  constexpr double r = 0.05, h = 1e-3;
  const NurbsCurve quarter = ellipse_arc(r, r, -M_PI / 2, 0);
  const TriangleMesh bowl = slab_mesh(RevolvedPatch(quarter), 2 * h, 1e-4);
  expect_closed(bowl);
  const double true_volume = 2 * M_PI / 3 * (std::pow(r + h, 3) - std::pow(r - h, 3));
  EXPECT_NEAR(volume_of(bowl), true_volume, 0.01 * true_volume);
  EXPECT_EQ(static_cast<long>(bowl.positions.size()) - static_cast<long>(bowl.triangles.size()) / 2, 2);
  for (const Vec3& x : bowl.positions) EXPECT_NEAR(std::abs(x.norm() - r), h, 1e-6);
  // A flat floor and a fillet: no finer than the circle, a polygon of 75 sides, asks for in powers of two.
  const NurbsCurve dish(2, clamped_knots(5, 2),
                        {{0, 0, 0}, {0.035, 0, 0}, {0.052, 0, 0}, {0.055, 0.006, 0}, {0.056, 0.024, 0}});
  EXPECT_EQ(refine_grid(RevolvedPatch(dish), 1e-4).u.size(), 129U);
  EXPECT_LT(refine_grid(RevolvedPatch(dish), 1e-4).v.size(), 30U);
}

TEST(Slab, TakesAPoleButNoPatchWithoutArea) {
  std::vector<Vec3> points = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0.1}, {0.1, 0, 0.1}};
  const NurbsSurface::Direction line{1, bezier_knots(1)};
  const TriangleMesh slab = slab_mesh(NurbsSurface(line, line, 2, points), 1e-3, 1e-4);
  for (const Vec3& x : slab.positions) EXPECT_TRUE(is_finite(x));
  points.assign(4, Vec3(1, 2, 3));
  EXPECT_THROW(slab_mesh(NurbsSurface(line, line, 2, points), 1e-3, 1e-4), InputError);
}

}  // namespace
}  // namespace prosector
