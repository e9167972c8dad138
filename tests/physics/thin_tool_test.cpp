#include <gtest/gtest.h>

#include <cmath>

#include "server/physics/mechanics/contact/rod.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

TEST(Rod, ClosestPointsOfSegmentAndTriangle) {
  const std::array<Vec3, 3> t = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)};
  EXPECT_NEAR(contact::closest({0.25, 1, 0.25}, {0.25, 3, 0.25}, t).distance, 1,
              1e-12);  // an end over the face
  EXPECT_NEAR(contact::closest({0.5, 0.3, -2}, {0.5, 0.3, -0.4}, t).distance, 0.5,
              1e-12);  // an end and an edge
  EXPECT_NEAR(contact::closest({0.5, 0.3, -0.4}, {0.5, -0.3, -0.4}, t).distance, 0.4,
              1e-12);  // across an edge
  const contact::SegmentTriangle through = contact::closest({0.2, 1, 0.3}, {0.2, -1, 0.3}, t);
  EXPECT_EQ(through.distance, 0);
  EXPECT_LT((through.weights - Vec3(0.5, 0.2, 0.3)).norm(), 1e-12);
  EXPECT_NEAR(contact::closest({-3, 0, -4}, {-3, 0, -4}, t).distance, 5, 1e-12);  // a point and a corner
}

/// A block with vertices 6 mm apart on the table, and a ball of 3 mm radius that lands between them.
SceneDesc bed(double mass) {
  SceneDesc scene;
  scene.rigid = {table(), part_body("tip", "sphere", {0.006, 0, 0}, {0.002, 0.0340, 0.001})};
  scene.rigid[1].material.mass = mass;
  scene.soft = {block()};
  scene.soft[0].geometry.size = {0.06, 0.03, 0.06};
  scene.soft[0].geometry.cell = scene.soft[0].geometry.surface_cell = 0.006;
  scene.soft[0].pose.p = {0, 0.015, 0};
  return scene;
}

TEST(ThinTool, TipBetweenVerticesDoesNotSlipThrough) {
  for (const double mass : {0.005, 0.02}) {
    Simulation simulation(bed(mass), options());
    double narrow = 0, total = 0;
    for (int i = 0; i < 120; ++i) {
      const StepReport& report = simulation.step({});
      narrow += report.seconds[static_cast<std::size_t>(Phase::narrow)];
      total += report.total_seconds;
      double surface = 0;  // height of the surface where the tip is: the nearest vertex's
      double nearest = 1;
      const Anatomy& anatomy = simulation.soft(2).anatomy();
      const Vec3 tip = simulation.rigid_state(1).pose.p;
      for (std::size_t v = 0; v < anatomy.surface.positions.size(); ++v) {
        const Vec3 x = anatomy.embedding.apply(v, simulation.soft_state(2).motion.x.data());
        const double away = std::hypot(x.x() - tip.x(), x.z() - tip.z());
        if (anatomy.surface.positions[v].y() < 0.0299 || away > nearest) continue;
        nearest = away;
        surface = x.y();
      }
      ASSERT_LT(nearest, 0.006) << "rolled away";
      EXPECT_GT(tip.y(), surface - 0.0015) << mass << " kg, tick " << i;
    }
    EXPECT_LT(simulation.rigid_state(1).linear_velocity.norm(), 0.02) << mass;
    EXPECT_GT(simulation.max_displacement(2), 1e-4) << mass;
    RecordProperty("narrow_share_percent", static_cast<int>(100 * narrow / total));
  }
}

}  // namespace
}  // namespace prosector::test
