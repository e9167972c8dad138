#include "drivers/camera/base/lens.h"

#include <gtest/gtest.h>

#include "tests/random.h"

namespace prosector {
namespace {

Lens bent_lens() {
  Lens lens;
  lens.cx = 322.3;
  lens.cy = 236.1;
  lens.k1 = -0.18;
  lens.k2 = 0.05;
  lens.p1 = 1e-3;
  lens.p2 = -8e-4;
  lens.k3 = -0.01;
  return lens;
}

TEST(Lens, PointsComeBackAlongTheirRays) {
  Random random(7);
  const Lens lens = bent_lens();
  for (int k = 0; k < 1000; ++k) {
    const Vec2 pixel(random.uniform(-30, lens.width + 30), random.uniform(-30, lens.height + 30));
    const Vec2 again = lens.project(random.uniform(0.1, 5) * lens.ray(pixel));
    EXPECT_LT((again - pixel).norm(), 1e-9) << pixel.transpose();
  }
}

TEST(Lens, BendsAsTheFormulaSays) {
  Lens lens;
  lens.k1 = -0.2;
  const Vec2 pixel = lens.project({0.4, 0, 1});
  EXPECT_NEAR(pixel.x(), 600 * 0.4 * (1 - 0.2 * 0.16) + 319.5, 1e-12);
  EXPECT_NEAR(pixel.y(), 239.5, 1e-12);
  lens.k1 = 0;
  lens.p1 = 0.01;
  EXPECT_NEAR(lens.project({0, 0.3, 1}).y(), 600 * (0.3 + 0.01 * 3 * 0.09) + 239.5, 1e-9);
}

TEST(Lens, OfAnotherSizeSeesTheSameDirections) {
  const Lens lens = bent_lens(), larger = lens.scaled(1280, 960);
  const Vec3 corner = lens.ray({-0.5, -0.5}), in_larger = larger.ray({-0.5, -0.5});
  EXPECT_LT((corner - in_larger).norm(), 1e-12);
  EXPECT_EQ(larger.scaled(640, 480).cx, lens.cx);
}

}  // namespace
}  // namespace prosector
