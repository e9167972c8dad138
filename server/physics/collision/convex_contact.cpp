#include "server/physics/collision/convex_contact.h"

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <cmath>

#include "server/physics/collision/gjk.h"

namespace prosector {
namespace {

// Bullet's tolerances are absolute, so shapes are brought to about this size.
constexpr double bullet_size = 20;

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

/// A core in the frame of the query: `origin` is at zero and lengths are multiplied by `scale`.
class BulletCore final : public btConvexInternalShape {
 public:
  BulletCore(const Convex& convex, const Pose& pose, const Vec3& origin, double scale)
      : convex_(convex), rotation_(pose.q.toRotationMatrix()), shift_(pose.p - origin), scale_(scale) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0;
  }

  /// m, not scaled.
  Vec3 farthest(const Vec3& direction) const {
    return rotation_ * convex_.farthest(rotation_.transpose() * direction) + shift_;
  }

  btVector3 localGetSupportingVertex(const btVector3& direction) const override {
    const Vec3 d = from_bullet(direction);
    return to_bullet(scale_ * farthest(d.isZero(0) ? Vec3(Vec3::UnitX()) : d));
  }
  btVector3 localGetSupportingVertexWithoutMargin(const btVector3& direction) const override {
    return localGetSupportingVertex(direction);
  }
  void batchedUnitVectorGetSupportingVertexWithoutMargin(const btVector3* directions, btVector3* out,
                                                         int count) const override {
    for (int i = 0; i < count; ++i) out[i] = localGetSupportingVertex(directions[i]);
  }
  void calculateLocalInertia(btScalar, btVector3& inertia) const override { inertia.setZero(); }
  const char* getName() const override { return "core"; }

 private:
  const Convex& convex_;
  Mat3 rotation_;
  Vec3 shift_;
  double scale_;
};

/// m: of the cores' supporting planes with that normal.
double gap_along(const Vec3& normal, const BulletCore& a, const BulletCore& b) {
  return normal.dot(a.farthest(-normal) - b.farthest(normal));
}

}  // namespace

std::optional<Proximity> convex_proximity(const Convex& a, const Pose& pose_a, const Convex& b,
                                          const Pose& pose_b, double margin) {
  const Vec3 center_a = pose_a * a.center(), center_b = pose_b * b.center();
  const Vec3 apart = center_a - center_b;
  const double rounding = a.rounding() + b.rounding(), reach = a.reach() + b.reach();
  if (!(apart.norm() - reach - rounding <= margin)) return std::nullopt;
  const Vec3 origin = (center_a + center_b) / 2;
  const double size = std::max(reach, apart.norm()), scale = size > 0 ? bullet_size / size : 1;
  const BulletCore core_a(a, pose_a, origin, scale), core_b(b, pose_b, origin, scale);

  Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
  const ClosestPoints closest = Gjk::run([&](const Vec3& d) { return core_a.farthest(d); },
                                         [&](const Vec3& d) { return core_b.farthest(d); },
                                         apart.isZero(0) ? Vec3(Vec3::UnitY()) : apart, size);
  if (closest.apart) {
    normal = closest.on_a - closest.on_b;
    middle = (closest.on_a + closest.on_b) / 2;
  } else {
    btGjkEpaSolver2::sResults found;
    const btTransform identity = btTransform::getIdentity();
    if (btGjkEpaSolver2::Penetration(&core_a, identity, &core_b, identity, to_bullet(scale * apart), found,
                                     false)) {
      normal = from_bullet(found.normal);
      middle = from_bullet(found.witnesses[0] + found.witnesses[1]) / (2 * scale);
    }
  }
  Proximity out;
  if (!(normal.norm() > 0) || !normal.allFinite() || !middle.allFinite()) {
    normal = apart;
    middle.setZero();
  }
  out.normal = normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitY());
  out.gap = gap_along(out.normal, core_a, core_b);
  out.on_a = origin + middle + out.gap / 2 * out.normal;
  out.on_b = origin + middle - out.gap / 2 * out.normal;
  out = rounded(out, a.rounding(), b.rounding());
  if (!(out.gap <= margin)) return std::nullopt;
  return out;
}

}  // namespace prosector
