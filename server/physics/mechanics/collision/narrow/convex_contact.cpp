#include "server/physics/mechanics/collision/narrow/convex_contact.h"

#include <BulletCollision/CollisionShapes/btConvexInternalShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "server/physics/mechanics/collision/narrow/gjk.h"

namespace prosector::collision {
namespace {

// Bullet's tolerances are absolute, so shapes are scaled to about this size.
constexpr double bullet_size = 20;
// Largest difference, relative to the size, between Bullet's depth and the depth of its supporting planes at
// which Bullet's depth is accepted as the minimum.
constexpr double certain = 1e-5;

btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

/// Core of a convex shape in the query frame: `origin` is at zero and lengths are multiplied by `scale`.
class BulletCore final : public btConvexInternalShape {
 public:
  BulletCore(const Convex& convex, const Pose& pose, const Vec3& origin, double scale)
      : convex_(convex), rotation_(pose.q.toRotationMatrix()), shift_(pose.p - origin), scale_(scale) {
    m_shapeType = CUSTOM_CONVEX_SHAPE_TYPE;
    m_collisionMargin = 0;
  }

  /// Returns the core's support point in a direction, m, not scaled.
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

/// Returns the signed gap, m, between the cores' supporting planes with this normal.
double gap_along(const Vec3& normal, const BulletCore& a, const BulletCore& b) {
  return normal.dot(a.farthest(-normal) - b.farthest(normal));
}

/// Rotates the normal of overlapping cores towards a smaller overlap of the planes, as long as the overlap
/// decreases. At a local minimum, the support point of b − a is parallel to the normal.
void descend(Vec3& normal, const BulletCore& a, const BulletCore& b) {
  constexpr int most_turns = 24, most_halvings = 6;
  double depth = -gap_along(normal, a, b);
  for (int turn = 0; turn < most_turns; ++turn) {
    const Vec3 ahead = b.farthest(normal) - a.farthest(-normal);
    const Vec3 aside = ahead - ahead.dot(normal) * normal;
    double share = ahead.norm() > 0 ? 1 / ahead.norm() : 0;
    bool better = false;
    for (int i = 0; i < most_halvings && !better; ++i, share /= 2) {
      const Vec3 turned = (normal - share * aside).normalized();
      const double found = -gap_along(turned, a, b);
      better = found < depth * (1 - 1e-9);
      if (!better) continue;
      normal = turned;
      depth = found;
    }
    if (!better) return;
  }
}

struct BulletDepth {
  Vec3 normal, middle;
  double depth_at_least,
      depth_at_most;  // m: of the polytope inside the Minkowski difference, of the planes outside
};

std::optional<BulletDepth> bullet_depth(const BulletCore& a, const BulletCore& b, const Vec3& apart,
                                        double scale) {
  btGjkEpaSolver2::sResults found;
  const btTransform identity = btTransform::getIdentity();
  if (!btGjkEpaSolver2::Penetration(&a, identity, &b, identity, to_bullet(scale * apart), found, false))
    return std::nullopt;
  const Vec3 normal = from_bullet(found.normal).normalized();
  const Vec3 middle = from_bullet(found.witnesses[0] + found.witnesses[1]) / (2 * scale);
  if (!normal.allFinite() || !middle.allFinite()) return std::nullopt;
  return BulletDepth{normal, middle, std::abs(static_cast<double>(found.distance)) / scale,
                     -gap_along(normal, a, b)};
}

/// Returns the normal of least depth found by descent from the best of many directions, Bullet's normal
/// included. Used when Bullet's bounds differ.
Vec3 searched_normal(const BulletCore& a, const BulletCore& b, const Pose& frame, const Vec3& apart,
                     const std::optional<BulletDepth>& found) {
  constexpr std::size_t tried = 4;
  std::vector<std::pair<double, Vec3>> starts;  // gap along the direction, m, and the direction
  const auto add = [&](const Vec3& n) { starts.emplace_back(gap_along(n, a, b), n); };
  if (found) add(found->normal);
  if (apart.norm() > 0) add(apart.normalized());
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) add(frame.q * Vec3(x, y, z).normalized());
  std::stable_sort(starts.begin(), starts.end(),
                   [](const auto& p, const auto& q) { return p.first > q.first; });
  for (std::size_t i = 0; i < tried; ++i) {
    descend(starts[i].second, a, b);
    starts[i].first = gap_along(starts[i].second, a, b);
  }
  return std::max_element(starts.begin(), starts.begin() + tried,
                          [](const auto& p, const auto& q) { return p.first < q.first; })
      ->second;
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
    const auto found = bullet_depth(core_a, core_b, apart, scale);
    if (found) middle = found->middle;
    if (found && found->depth_at_most - found->depth_at_least <= certain * size) {
      normal = found->normal;
      descend(normal, core_a, core_b);
    } else {
      normal = searched_normal(core_a, core_b, pose_a, apart, found);
    }
  }
  Proximity out;
  out.normal = normal.normalized();
  out.gap = gap_along(out.normal, core_a, core_b);
  out.on_a = origin + middle + out.gap / 2 * out.normal;
  out.on_b = origin + middle - out.gap / 2 * out.normal;
  out = rounded(out, a.rounding(), b.rounding());
  if (!(out.gap <= margin)) return std::nullopt;
  return out;
}

}  // namespace prosector::collision
