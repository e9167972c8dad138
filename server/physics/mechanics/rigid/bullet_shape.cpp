#include "server/physics/mechanics/rigid/bullet_shape.h"

#include <BulletCollision/Gimpact/btGImpactShape.h>

#include <numbers>

namespace prosector::rigid {
namespace {

constexpr btScalar mesh_margin = 0.0005F;  // m: Bullet enlarges hulls and triangle meshes by it

/// Returns a hull of evenly distributed points on the ellipsoid (Fibonacci lattice), since Bullet has no
/// ellipsoid.
std::unique_ptr<btConvexHullShape> ellipsoid(const Vec3& half) {
  constexpr int count = 96;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  auto hull = std::make_unique<btConvexHullShape>();
  for (int i = 0; i < count; ++i) {
    const double y = 1 - 2 * (i + 0.5) / count, r = std::sqrt(1 - y * y), angle = golden * i;
    hull->addPoint(to_bullet(half.cwiseProduct(Vec3(r * std::cos(angle), y, r * std::sin(angle)))), false);
  }
  hull->recalcLocalAabb();
  hull->setMargin(mesh_margin);
  return hull;
}

std::unique_ptr<btTriangleMesh> triangle_mesh(const TriangleMesh& mesh) {
  auto out = std::make_unique<btTriangleMesh>();
  for (const auto& t : mesh.triangles)
    out->addTriangle(to_bullet(mesh.positions[t[0]]), to_bullet(mesh.positions[t[1]]),
                     to_bullet(mesh.positions[t[2]]));
  return out;
}

std::unique_ptr<btCollisionShape> make_part(const collision::ShapePart& part, bool dynamic,
                                            BulletShape& owner) {
  const auto r = static_cast<btScalar>(part.half.x());
  const auto y = static_cast<btScalar>(part.half.y());
  switch (part.kind) {
    case collision::ShapeKind::box:
      return std::make_unique<btBoxShape>(to_bullet(part.half));
    case collision::ShapeKind::sphere:
      return std::make_unique<btSphereShape>(r);
    case collision::ShapeKind::capsule:
      return std::make_unique<btCapsuleShape>(r, 2 * y);
    case collision::ShapeKind::cylinder:
      return std::make_unique<btCylinderShape>(btVector3(r, y, r));
    case collision::ShapeKind::ellipsoid:
      return ellipsoid(part.half);
    case collision::ShapeKind::hull: {
      auto hull = std::make_unique<btConvexHullShape>();
      for (const Vec3& p : part.mesh->positions) hull->addPoint(to_bullet(p), false);
      hull->recalcLocalAabb();
      hull->setMargin(mesh_margin);
      return hull;
    }
    case collision::ShapeKind::triangles: {
      owner.meshes.push_back(triangle_mesh(*part.mesh));
      if (!dynamic) return std::make_unique<btBvhTriangleMeshShape>(owner.meshes.back().get(), true);
      auto moving = std::make_unique<btGImpactMeshShape>(owner.meshes.back().get());
      moving->setMargin(mesh_margin);
      moving->updateBound();
      return moving;
    }
  }
  return nullptr;
}

bool is_identity(const Pose& pose) {
  return pose.p.isZero(0) && pose.q.vec().isZero(0);
}

}  // namespace

BulletShape make_bullet_shape(const std::vector<collision::ShapePart>& parts, bool dynamic) {
  BulletShape out;
  for (const collision::ShapePart& part : parts) out.parts.push_back(make_part(part, dynamic, out));
  if (parts.size() == 1 && is_identity(parts.front().pose)) {
    out.root = out.parts.front().get();
  } else if (!parts.empty()) {
    out.compound = std::make_unique<btCompoundShape>(true, static_cast<int>(parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i)
      out.compound->addChildShape(to_bullet(parts[i].pose), out.parts[i].get());
    out.root = out.compound.get();
  }
  return out;
}

}  // namespace prosector::rigid
