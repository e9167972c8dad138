// What encloses encloses.

#include "server/physics/mechanics/collision/outlines/bounding.h"

#include <gtest/gtest.h>

#include "tests/collision/shapes.h"

namespace prosector {
namespace {

using namespace test;

TEST(Bounding, EnclosesRandomClouds) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    std::vector<Vec3> points = random_cloud(random, 1 + i % 40);
    const Pose pose = random_pose(random, 10);
    for (Vec3& x : points) x = pose * x;
    const double rounding = i % 2 ? 0 : between(random, 0, 0.3);
    const std::vector<collision::Cloud> clouds{{points, rounding}};
    const collision::Aabb box = collision::enclosing_box(clouds);
    const collision::SphereShape sphere = collision::enclosing_sphere(clouds);
    const collision::BoxShape turned = collision::enclosing_oriented_box(clouds);
    for (const Vec3& x : points) {
      for (int k = 0; k < 5; ++k) {
        const Vec3 y = x + rounding * random_unit(random);
        EXPECT_TRUE(box.contains({y, y}));
        EXPECT_LE((y - sphere.center).norm(), sphere.radius + 1e-14);
        EXPECT_TRUE(((turned.pose.inverse() * y).cwiseAbs().array() <= turned.half.array() + 1e-13).all());
      }
    }
  }
}

TEST(Bounding, SphereOfTheLargestHalfExtentWouldNotEnclose) {
  const auto cube = collision::box_surface(Vec3::Ones());
  const std::vector<collision::Cloud> clouds{{cube->positions(), 0}};
  EXPECT_NEAR(collision::enclosing_sphere(clouds).radius, std::sqrt(3.0), 1e-15);
  EXPECT_EQ(collision::enclosing_box(clouds).half().maxCoeff(), 1);
}

TEST(Bounding, OrientedBoxFindsATurnedBoxAgain) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 half(1, 0.5, 0.1);
    const Pose pose = random_pose(random);
    std::vector<Vec3> points;
    const auto box = collision::box_surface(half);
    for (const Vec3& x : box->positions()) points.push_back(pose * x);
    const std::vector<collision::Cloud> clouds{{points, 0}};
    const collision::BoxShape found = collision::enclosing_oriented_box(clouds);
    EXPECT_NEAR(found.half.prod(), half.prod(), 1e-9);
    EXPECT_LT((found.pose.p - pose.p).norm(), 1e-9);
    EXPECT_NEAR(found.pose.q.toRotationMatrix().determinant(), 1, 1e-9);
  }
}

}  // namespace
}  // namespace prosector
