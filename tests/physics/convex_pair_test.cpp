// Contacts of small convex bodies, which Bullet's GJK misses in metres.

#include <gtest/gtest.h>

#include <algorithm>

#include "server/physics/mechanics/rigid/rigid_world.h"
#include "tests/physics/rigid_setup.h"

namespace prosector::test {
namespace {

using collision::ShapeKind;

/// Returns the least gap that the world finds between its bodies, m; 1: none.
double least_gap(rigid::RigidWorld& world) {
  const std::size_t all[] = {1};
  world.detect(1.0 / 60);
  world.find_islands({}, all);
  double least = 1;
  for (const rigid::MixedIsland& island : world.solve(1.0 / 60))
    for (const rigid::RigidContact& c : island.contacts) least = std::min(least, c.gap);
  return least;
}

TEST(ConvexPair, DepthsAreThoseOfTheShapesAtAnySize) {
  for (const double size : {0.001, 0.01, 0.1, 1.0})
    for (const double depth : {0.02, 0.1, 0.2})
      for (const double thickness : {0.25, 0.5, 2.0}) {
        SCOPED_TRACE(testing::Message() << size << " m, depth " << depth << ", plate " << thickness);
        const auto gap = [&](const collision::ShapePart& body) {
          rigid::RigidWorld world(Vec3::Zero());
          world.add(rigid_setup({rigid_part(ShapeKind::box, size * Vec3(20, thickness / 2, 20))}, 0), {});
          world.add(rigid_setup({body}, 1),
                    rigid_motion(size * Vec3(0.3, 1 + thickness / 2 - depth, 0.2), Vec3::Zero()));
          return least_gap(world);
        };
        const double tolerance = 0.02 * size;
        EXPECT_NEAR(gap(rigid_part(ShapeKind::sphere, {size, 0, 0})), -depth * size, tolerance);
        EXPECT_NEAR(gap(rigid_part(ShapeKind::cylinder, {size, size, 0})), -depth * size, tolerance);
        EXPECT_NEAR(gap(rigid_part(ShapeKind::capsule, {size / 2, size / 2, 0})), -depth * size, tolerance);
      }
}

}  // namespace
}  // namespace prosector::test
