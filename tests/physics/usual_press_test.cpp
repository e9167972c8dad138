// The force that a user feels by default: on tissue that names its material only.

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/physics/layer_press.h"
#include "tests/physics/scenes.h"
#include "tests/physics/usual_press.h"

namespace prosector::test {
namespace {

class UsualPress : public ::testing::TestWithParam<LayerPress> {};

TEST_P(UsualPress, IsRightAndSmooth) {
  const LayerPress& press = GetParam();
  Simulation simulation(usual_layer(press.height, press.poisson_ratio, press.radius), options());
  const Slide slide = press_and_slide(simulation, press.radius, press.depth,
                                      [&](const TickInput& input) { simulation.step(input); });
  EXPECT_NEAR(slide.force / press.force, 1, 0.1);
  EXPECT_GT(slide.least / press.force, 0.9);
  EXPECT_LT(slide.most / press.force, 1.1);
  EXPECT_LT(slide.largest_change, 0.02);
  std::printf("held %.3f, sliding %.3f to %.3f, largest change %.4f\n", slide.force / press.force,
              slide.least / press.force, slide.most / press.force, slide.largest_change);
}

INSTANTIATE_TEST_SUITE_P(Layers, UsualPress, ::testing::ValuesIn(layer_presses));

}  // namespace
}  // namespace prosector::test
