// Colours that tell strain, and the scale that explains them.

#include "client/view/value_paint.h"

#include <gtest/gtest.h>

#include "client/view/auto_range.h"
#include "common/error_map.h"

namespace prosector {
namespace {

// Of floats up to 4 m from the origin, over edges of 0.1 m: rounding at both ends.
constexpr double tolerance = 2 * 4 * 6e-8 / 0.1;

/// A square of two triangles, 0.1 m a side, that some map has deformed.
template <class Map>
DrawMesh square(const Map& map) {
  DrawMesh out;
  out.rest_positions = {{0, 0, 0}, {0.1F, 0, 0}, {0.1F, 0.1F, 0}, {0, 0.1F, 0}};
  for (const Eigen::Vector3f& x : out.rest_positions) out.positions.push_back(map(x));
  out.normals.assign(4, Eigen::Vector3f::UnitZ());
  out.triangles = {{0, 1, 2}, {0, 2, 3}};
  return out;
}

DrawMesh stretched(float x, float y) {
  return square([&](const Eigen::Vector3f& p) { return Eigen::Vector3f(x * p.x(), y * p.y(), 0); });
}

void expect_everywhere(const DrawMesh& mesh, double strain) {
  for (const double found : surface_strains(mesh)) EXPECT_NEAR(found, strain, tolerance);
}

TEST(SurfaceStrain, IsTheLargestPrincipalStretchLessOne) {
  expect_everywhere(stretched(1.2F, 0.9F), 0.2);
  expect_everywhere(stretched(0.8F, 0.9F), -0.1);
  // Simple shear by γ: stretch (γ + √(γ² + 4)) / 2.
  expect_everywhere(
      square([](const Eigen::Vector3f& p) { return Eigen::Vector3f(p.x() + 0.5F * p.y(), p.y(), 0); }),
      (0.5 + std::sqrt(4.25)) / 2 - 1);
}

TEST(SurfaceStrain, IsNoneOfWhatMovedRigidly) {
  const Eigen::Quaternionf q(Eigen::AngleAxisf(1.1F, Eigen::Vector3f(1, 2, -1).normalized()));
  expect_everywhere(
      square([&](const Eigen::Vector3f& p) { return Eigen::Vector3f(q * p + Eigen::Vector3f(1, 2, 3)); }), 0);
}

TEST(SurfaceStrain, OfSliversWithoutAreaAtRestIsLeftOut) {
  DrawMesh mesh = stretched(1.2F, 1);
  mesh.triangles.push_back({0, 1, 1});
  expect_everywhere(mesh, 0.2);
}

TEST(ValueColor, OfAKnownStretchIsThatOfTheLegend) {
  const ValueScale& scale = scale_of(Shown::strain);
  PaintedMesh painted(7);
  const DrawMesh mesh = stretched(1.15F, 1);  // half the scale
  const auto seen = painted.of(mesh, scale, std::nullopt);
  EXPECT_EQ(seen->id, 7u);
  for (const Eigen::Vector3f& color : seen->rest_positions)
    EXPECT_LT((color.cast<double>() - value_color(scale, 0.15)).norm(), 1e-4);
  DrawList list;
  list.cameras.emplace_back();
  add_legend(list, scale);
  double nearest = 1;
  for (const DrawLine& line : list.lines)
    nearest = std::min(nearest, (line.color - value_color(scale, 0.15)).norm());
  EXPECT_LT(nearest, 0.02);
  std::string words = "\n";
  for (const DrawText& text : list.texts) words += text.text + "\n";
  for (const char* expected : {"strain, %", "\n0\n", "\n15\n", "\n30 or more\n"})
    EXPECT_NE(words.find(expected), std::string::npos) << expected << " in\n" << words;
}

TEST(ValueColor, IsPaintedAnewOnlyWhenSomethingChanged) {
  DrawMesh mesh = stretched(1.1F, 1);
  PaintedMesh painted(7);
  const auto seen = painted.of(mesh, scale_of(Shown::error), 0.1);
  const std::uint64_t first = seen->revision;
  (void)painted.of(mesh, scale_of(Shown::error), 0.1);
  EXPECT_EQ(seen->revision, first);
  (void)painted.of(mesh, scale_of(Shown::error), not_known);
  EXPECT_EQ(seen->revision, first + 1);
  EXPECT_NEAR(seen->rest_positions[0].x(), seen->rest_positions[0].z(), 1e-6) << "not known is gray";
  (void)painted.of(mesh, scale_of(Shown::strain), std::nullopt);
  mesh.positions[2].x() += 0.1F;
  ++mesh.positions_revision;
  const Eigen::Vector3f before = seen->rest_positions[2];
  (void)painted.of(mesh, scale_of(Shown::strain), std::nullopt);
  EXPECT_GT((seen->rest_positions[2] - before).norm(), 0.1F);
}

/// Each vertex has the error that the map has at its rest position.
TEST(ValueColor, OfAnErrorIsThatOfItsPlace) {
  const ValueScale& scale = scale_of(Shown::error);
  const DrawMesh mesh = stretched(1.1F, 1);
  ErrorMap map;
  map.cell = 0.1;
  map.size = {2, 1, 1};
  map.levels = {level_of(0.02), level_of(0.18)};
  PaintedMesh painted(7);
  const auto seen = painted.of(mesh, scale, 0.1, &map);
  ASSERT_EQ(seen->rest_positions.size(), 4u);
  for (const auto& [vertex, error] : {std::pair(0u, 0.02), std::pair(1u, 0.18), std::pair(3u, 0.02)})
    EXPECT_LT((seen->rest_positions[vertex].cast<double>() - value_color(scale, error)).norm(), 0.03)
        << vertex;
  EXPECT_GT((seen->rest_positions[0] - seen->rest_positions[1]).norm(), 0.3F);
  const std::uint64_t first = seen->revision;
  map.levels[1] = level_of(0.05);
  (void)painted.of(mesh, scale, 0.1, &map);
  EXPECT_EQ(seen->revision, first + 1);
  EXPECT_LT((seen->rest_positions[1].cast<double>() - value_color(scale, 0.05)).norm(), 0.03);
}

TEST(ValueColor, OfALogarithmicScaleGoesByPowersOfTen) {
  const ValueScale& scale = scale_of(Shown::residual);
  EXPECT_LT((value_color(scale, 0) - value_color(scale, 1e-8)).norm(), 1e-12);
  EXPECT_GT((value_color(scale, 1e-6) - value_color(scale, 1e-8)).norm(), 0.1);
}

TEST(AutoRange, EndsAtOneTwoOrFiveTimesAPowerOfTen) {
  for (const auto& [largest, end] : {std::pair(0.0, 0.01),
                                     {0.004, 0.01},
                                     {0.011, 0.02},
                                     {0.03, 0.05},
                                     {0.05, 0.05},
                                     {0.07, 0.1},
                                     {0.3, 0.5},
                                     {3.0, 5.0}})
    EXPECT_NEAR(AutoRange(0.01).follow(std::vector<double>(100, largest)), end, 1e-12) << largest;
  EXPECT_EQ(AutoRange(0.01).follow({}), 0.01);
  EXPECT_EQ(AutoRange(0.01).follow({not_known, not_known}), 0.01);
}

TEST(AutoRange, IsNotSetByAFewValuesAlone) {
  std::vector<double> values(1000, 0.015);
  values[7] = 0.3;
  EXPECT_NEAR(AutoRange(0.01).follow(values), 0.1, 1e-12) << "a third of the largest";
}

TEST(AutoRange, RisesAtOnceAndFallsWhenValuesAreWellBelow) {
  AutoRange range(0.01);
  const auto follow = [&](double value) { return range.follow(std::vector<double>(100, value)); };
  EXPECT_NEAR(follow(0.15), 0.2, 1e-12);
  EXPECT_NEAR(follow(0.09), 0.2, 1e-12) << "not yet below 80 % of 10 %";
  EXPECT_NEAR(follow(0.11), 0.2, 1e-12);
  EXPECT_NEAR(follow(0.079), 0.1, 1e-12);
  EXPECT_NEAR(follow(0), 0.01, 1e-12);
}

}  // namespace
}  // namespace prosector
