#pragma once
// Bullet's world with its step in phases, and its filter of pairs. Only for the .cpp files of this folder.

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <btBulletDynamicsCommon.h>

#include <span>
#include <utility>

#include "server/physics/mechanics/collision/broad/collision_mask.h"

namespace prosector::rigid {

/// Filter of broad-phase pairs. Bullet's groups and masks are those of the scene. In addition, hands don't
/// collide with hands, and static objects don't collide with each other.
class PairFilter final : public btOverlapFilterCallback {
 public:
  static void mark_hand(btCollisionObject& object) { object.setUserIndex2(1); }

  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const auto &first = object(a), &second = object(b);
    return collision::may_touch(mask(a), mask(b)) && !(is_hand(first) && is_hand(second)) &&
           !(first.isStaticObject() && second.isStaticObject());
  }

 private:
  static const btCollisionObject& object(const btBroadphaseProxy* proxy) {
    return *static_cast<const btCollisionObject*>(proxy->m_clientObject);
  }
  static collision::CollisionMask mask(const btBroadphaseProxy* proxy) {
    return {static_cast<std::uint32_t>(proxy->m_collisionFilterGroup),
            static_cast<std::uint32_t>(proxy->m_collisionFilterMask)};
  }
  static bool is_hand(const btCollisionObject& object) { return object.getUserIndex2() == 1; }
};

/// Bullet's world with its step split at the constraint stage.
class PhasedWorld final : public btDiscreteDynamicsWorld {
 public:
  using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

  void detect(btScalar h) {
    applyGravity();
    predictUnconstraintMotion(h);
    btDispatcherInfo& info = getDispatchInfo();
    info.m_timeStep = h;
    info.m_stepCount = 0;
    createPredictiveContacts(h);
    performDiscreteCollisionDetection();
  }

  void find_islands(std::span<const std::pair<btRigidBody*, btRigidBody*>> links) {
    btSimulationIslandManager& islands = *getSimulationIslandManager();
    islands.updateActivationState(this, getDispatcher());
    for (const auto& [a, b] : links) islands.getUnionFind().unite(a->getIslandTag(), b->getIslandTag());
    islands.storeIslandActivationState(this);
  }

  void solve(btScalar h, btSimulationIslandManager::IslandCallback& callback) {
    getSolverInfo().m_timeStep = h;
    getSimulationIslandManager()->buildAndProcessIslands(getDispatcher(), this, &callback);
    getConstraintSolver()->allSolved(getSolverInfo(), nullptr);
  }

  void integrate(btScalar h) {
    integrateTransforms(h);
    updateActivationState(h);
    clearForces();
  }
};

}  // namespace prosector::rigid
