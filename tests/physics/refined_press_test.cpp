// What is felt of elements that are smaller where a ball presses: the same as of that mesh by itself.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "common/anatomy/embedding.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/pressed_layer.h"
#include "tests/physics/scenes.h"
#include "tests/physics/under_ball.h"

namespace prosector::test {
namespace {

constexpr double mm = 1e-3, radius = 10 * mm, depth = 2 * mm, height = 20 * mm, width = 120 * mm;
constexpr double coarse = 10 * mm;

SoftDesc described(double refine_cell) {
  SoftDesc layer;
  layer.name = "layer";
  layer.configuration.model = "fem_corotational";
  layer.material.youngs_modulus = 5000;
  layer.material.poisson_ratio = 0.45;
  layer.contact.points = ContactPoints::surface;
  layer.material.damping_mass = 5;
  layer.geometry.cell = coarse;
  layer.attach = {bonded_below(height)};
  if (refine_cell > 0) {
    layer.refinement.at = Refining::touch;
    layer.refinement.cell = refine_cell;
    layer.refinement.reach = radius;
    layer.refinement.max_elements = 20000;
  }
  return layer;
}

/// Makes the layer and presses the ball into its middle until it is at rest.
std::unique_ptr<Simulation> under_press(const SoftDesc& layer, const Anatomy& anatomy) {
  CompileOptions options;
  options.threads = 1;
  options.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> { return anatomy; };
  auto out = std::make_unique<Simulation>(under_ball(layer, radius, {0, 2 * radius, 0}), options);
  constexpr int down = 15, ticks = 45;
  for (int tick = 1; tick <= ticks; ++tick)
    out->step(ball_at({0, radius - depth * std::min(1.0, tick / double{down}), 0}));
  return out;
}

class RefinedPress : public ::testing::TestWithParam<double> {};

// Both have the same surface, which hangs on the elements. Pressed through another surface, such as its own
// boundary, the refined mesh differs by up to 12 %.
TEST_P(RefinedPress, FeelsLikeTheSameMeshByItself) {
  const double cell = GetParam();
  const TriangleMesh surface = even_layer(width, height, cell).surface;
  const Anatomy hanging = embed(even_layer(width, height, coarse).tets, surface).anatomy;
  const auto followed = under_press(described(cell), hanging);
  const auto itself = under_press(described(0), embed(followed->soft(1).anatomy().tets, surface).anatomy);
  ASSERT_GT(tet_count(*followed), hanging.tets.tets.size() + 300);
  EXPECT_EQ(tet_count(*followed), tet_count(*itself));
  EXPECT_NEAR(pressing_force(*followed) / pressing_force(*itself), 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Cells, RefinedPress, ::testing::Values(5 * mm, 10. / 3 * mm));

}  // namespace
}  // namespace prosector::test
