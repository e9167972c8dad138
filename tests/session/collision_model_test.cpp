// What clients are told that bodies collide as.

#include "server/session/sending/collision_model.h"

#include <gtest/gtest.h>

#include "common/scene/primitives.h"

namespace prosector {
namespace {

/// An L of two boxes as one mesh, turned in the scene.
RigidDesc bracket() {
  RigidDesc body;
  body.geometry.mesh = "bracket.obj";
  body.pose.q = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  return body;
}
TriangleMesh surface() {
  std::vector<PartDesc> parts(2);
  parts[0].size = {0.2, 0.04, 0.04};
  parts[1].size = {0.04, 0.1, 0.04};
  parts[1].pose.p = {0.08, 0.05, 0};
  return mesh_of(parts);
}

/// Largest distance by which a point is outside of a convex mesh.
double outside(const TriangleMesh& convex, const Vec3& point) {
  double most = -1;
  for (const auto& t : convex.triangles) {
    const Vec3& a = convex.positions[t[0]];
    const Vec3 normal = (convex.positions[t[1]] - a).cross(convex.positions[t[2]] - a);
    if (normal.norm() > 1e-12) most = std::max(most, normal.normalized().dot(point - a));
  }
  return most;
}

TEST(CollisionModel, OutlinesEncloseTheSurface) {
  RigidDesc body = bracket();
  const TriangleMesh mesh = surface();
  for (const Fidelity fidelity : {Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull}) {
    const std::string_view word = fidelity_name(fidelity);
    body.contact.collision = fidelity;
    const auto outline = collision_outline(body, mesh);
    ASSERT_TRUE(outline) << word;
    for (const Vec3& x : mesh.positions) EXPECT_LT(outside(*outline, x), 5e-4) << word;
  }
  body.contact.collision = Fidelity::aabb;
  const TriangleMesh box = collision_outline(body, mesh).value();
  for (const auto& t : box.triangles) {
    const auto& p = box.positions;
    const Vec3 normal = body.pose.q * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized();
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1, 1e-6) << "along the room's axes";
  }
}

TEST(CollisionModel, OthersCollideAsTheirSurfaceOrNotAtAll) {
  RigidDesc body = bracket();
  body.contact.collision = Fidelity::mesh;
  EXPECT_FALSE(collision_outline(body, surface()));
  body.contact.collision = Fidelity::none;
  EXPECT_FALSE(collision_outline(body, surface()));
  body.contact.collision = Fidelity::hull;
  body.geometry.parts.resize(1);
  EXPECT_FALSE(collision_outline(body, surface())) << "its parts are convex as they are";
}

}  // namespace
}  // namespace prosector
