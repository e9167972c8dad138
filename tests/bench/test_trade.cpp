// Tests the reference solutions of trade: closed forms, symmetry, and convergence of finer meshes.

#include <gtest/gtest.h>

#include <cmath>

#include "server/accuracy/act.h"
#include "server/calibration/rung.h"
#include "tests/bench/pressed_tissue.h"
#include "tests/bench/weighed_reference.h"
#include "tests/soft/kuhn.h"

namespace prosector {
namespace {

/// The work of the weight of a stiff hanging bar with ν = 0 is ρ²g²AL³/3E, J.
TEST(Weighed, AHangingBarsWeightGoesAsFarAsTheClosedFormSays) {
  constexpr double modulus = 1e7, gravity = 9.81;
  SoftDesc desc = weighed_desc(weighed_cube, "tet4", 0);
  desc.material.youngs_modulus = modulus;
  const Weighed bar(desc, kuhn_anatomy({2, 8, 2}, weighed_cube.size), gravity);
  ASSERT_TRUE(bar.answer.usable());
  const VecX load = load_of({"weight", Vec3(0, gravity, 0), {}}, bar.body);
  const double work = load.dot(bar.answer.x - bar.body.rest());
  const Vec3& size = weighed_cube.size;
  const double right =
      std::pow(weighed_density * gravity, 2) * size.prod() * size[1] * size[1] / (3 * modulus);
  EXPECT_NEAR(work / right, 1, 0.01);
}

/// All nodes of the foot are held, including its corners.
TEST(TestPiece, IsHeldAllOverItsFoot) {
  const Vec3 size(0.3, 0.06, 0.3);
  TestPiece piece;
  piece.mesh = kuhn_box({2, 2, 2}, size);
  piece.youngs_modulus = weighed_modulus;
  piece.clamped_axis = 1;
  const auto specimen = make_specimen({"fem_neo_hookean", "implicit_euler", "multigrid"}, piece);
  for (int i = 0; i < 5; ++i) specimen->step(1. / 60, {0, -9.81, 0});
  const VecX moved = specimen->positions() - specimen->rest();
  for (Eigen::Index k = 0; k < moved.size(); k += 3) {
    if (specimen->rest()[k + 1] > 0) continue;
    EXPECT_LT(moved.segment<3>(k).norm(), 1e-6);
  }
  EXPECT_GT(moved.norm(), 1e-4);
}

class Reference : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Weighed, Reference, testing::Range<std::size_t>(0, 3),
                         [](const auto& info) { return std::string(weighed_references()[info.param].name); });

/// The stored displacements must be symmetric, like the body.
TEST_P(Reference, IsSymmetric) {
  const auto& moved = weighed_references()[GetParam()].moved;
  EXPECT_EQ(moved[0], Vec3(0, moved[0][1], 0));
  EXPECT_EQ(moved[1][0], 0);
  EXPECT_EQ(moved[2][0], moved[2][2]);
  EXPECT_EQ(moved[3][2], 0);
}

/// Halving the cells at least halves the error.
TEST_P(Reference, FinerMeshesLeadThere) {
  const WeighedReference& which = weighed_references()[GetParam()];
  const double coarse = error_of(which, moved_at_rest(which, 1)),
               middle = error_of(which, moved_at_rest(which, 2)),
               fine = error_of(which, moved_at_rest(which, 4));
  EXPECT_LT(middle, coarse / 2);
  EXPECT_LT(fine, 0.65 * middle);
  EXPECT_LT(fine, 0.03);
}

TEST(Extrapolated, IsTheLimitOfWhatFallsEvenly) {
  std::array<std::array<Vec3, weighed_places>, 3> by_mesh;
  for (std::size_t i = 0; i < 3; ++i) by_mesh[i].fill(Vec3(1 + std::pow(0.25, i), 2 - std::pow(0.5, i), 3));
  for (const Vec3& limit : extrapolated(by_mesh)) EXPECT_LT((limit - Vec3(1, 2, 3)).norm(), 1e-12);
}

/// At small strain a layer's force matches the table of converged finite-layer forces.
TEST(Pressed, LinearLayerBearsWhatTheTableSays) {
  // The table assumes a flat ball. At this ν, fine quadratic elements bear 0.977 to 0.995 of its forces
  // (`prosector-bench contact --case hertz`). Linear ones bear 0.967 to 0.975 in cells of 4 to 1.1 mm.
  constexpr double converged = 0.986;
  PressedBody shallow = pressed_layer_body();
  shallow.depth = 0.001;
  SoftDesc desc = pressed_desc(shallow, 1.6e-3);
  desc.configuration.model = "fem_linear";
  EXPECT_NEAR(force_at_rest(shallow, desc) / 0.03128, converged, 0.02);
}

/// Meshes finer than real-time ones converge to the stored force from above.
TEST(Pressed, FinerMeshesLeadToTheStoredForces) {
  for (const auto& [body, coarse, fine] :
       {std::tuple(&pressed_layer_body(), 4e-3, 2.25e-3), {&pressed_organ(), 8e-3, 4.5e-3}}) {
    const double first = force_at_rest(*body, pressed_desc(*body, coarse)) / body->force,
                 second = force_at_rest(*body, pressed_desc(*body, fine)) / body->force;
    EXPECT_LT(std::abs(second - 1), std::abs(first - 1)) << body->name;
    EXPECT_NEAR(second, 1, 0.05) << body->name;
  }
}

}  // namespace
}  // namespace prosector
