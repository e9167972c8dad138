#include "server/physics/mechanics/rigid/bullet_sweep.h"

#include <algorithm>

namespace prosector::rigid {
namespace {

/// Closest hit of a swept ball on a body that it approaches and does not touch yet.
class NearestAhead final : public btCollisionWorld::ClosestConvexResultCallback {
 public:
  NearestAhead(const btRigidBody& own, btDispatcher& dispatcher, const btVector3& from, const btVector3& to)
      : ClosestConvexResultCallback(from, to), own_(own), dispatcher_(dispatcher), way_(to - from) {
    m_collisionFilterGroup = own.getBroadphaseProxy()->m_collisionFilterGroup;
    m_collisionFilterMask = own.getBroadphaseProxy()->m_collisionFilterMask;
  }

  bool needsCollision(btBroadphaseProxy* proxy) const override {
    const auto& other = *static_cast<const btCollisionObject*>(proxy->m_clientObject);
    return &other != &own_ && ClosestConvexResultCallback::needsCollision(proxy) &&
           dispatcher_.needsCollision(&own_, &other) && !touches(other);
  }

  btScalar addSingleResult(btCollisionWorld::LocalConvexResult& hit, bool world_normal) override {
    const btTransform& pose = hit.m_hitCollisionObject->getWorldTransform();
    const btVector3 normal = world_normal ? hit.m_hitNormalLocal : pose.getBasis() * hit.m_hitNormalLocal;
    if (normal.dot(way_) >= 0) return m_closestHitFraction;
    return ClosestConvexResultCallback::addSingleResult(hit, world_normal);
  }

 private:
  bool touches(const btCollisionObject& other) const {
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(m);
      if (manifold.getNumContacts() == 0) continue;
      if ((manifold.getBody0() == &own_ && manifold.getBody1() == &other) ||
          (manifold.getBody1() == &own_ && manifold.getBody0() == &other))
        return true;
    }
    return false;
  }

  const btRigidBody& own_;
  btDispatcher& dispatcher_;
  btVector3 way_;
};

btScalar least_half_extent(const btCollisionShape& shape) {
  btVector3 lo, hi;
  shape.getAabb(btTransform::getIdentity(), lo, hi);
  const btVector3 extent = hi - lo;
  return std::min({extent.x(), extent.y(), extent.z()}) / 2;
}

}  // namespace

btScalar free_motion(btCollisionWorld& world, const btRigidBody& body, btScalar h) {
  if (!body.getCollisionShape()->isCompound()) return 1;
  const auto& parts = *static_cast<const btCompoundShape*>(body.getCollisionShape());
  btTransform end;
  btTransformUtil::integrateTransform(body.getWorldTransform(), body.getLinearVelocity(),
                                      body.getAngularVelocity(), h, end);
  btScalar least = 1;
  for (int i = 0; i < parts.getNumChildShapes(); ++i) {
    if (!parts.getChildShape(i)->isConvex()) continue;
    const btVector3& middle = parts.getChildTransform(i).getOrigin();
    const btTransform from(btQuaternion::getIdentity(), body.getWorldTransform() * middle),
        to(btQuaternion::getIdentity(), end * middle);
    const btScalar radius = least_half_extent(*parts.getChildShape(i));
    if ((to.getOrigin() - from.getOrigin()).length2() <= radius * radius) continue;
    NearestAhead nearest(body, *world.getDispatcher(), from.getOrigin(), to.getOrigin());
    const btSphereShape ball(static_cast<btScalar>(swept_share) * radius);
    world.convexSweepTest(&ball, from, to, nearest);
    least = std::min(least, nearest.m_closestHitFraction);
  }
  return least;
}

}  // namespace prosector::rigid
