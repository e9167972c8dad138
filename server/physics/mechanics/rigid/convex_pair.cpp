#include "server/physics/mechanics/rigid/convex_pair.h"

#include <BulletCollision/CollisionDispatch/btActivatingCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btUniformScalingShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace prosector::rigid {
namespace {

btScalar radius_of(const btConvexShape& shape) {
  btVector3 center;
  btScalar radius = 0;
  shape.getBoundingSphere(center, radius);
  return radius;
}

/// Returns the number of units per metre: a power of two, so that scaling does not round.
btScalar units_per_metre(const btConvexShape& a, const btConvexShape& b) {
  const btScalar smaller = std::min(radius_of(a), radius_of(b));
  return smaller > 0 ? std::ldexp(btScalar(1), 2 - std::ilogb(smaller)) : 1;
}

btTransform scaled(const btTransform& pose, const btVector3& origin, btScalar scale) {
  return btTransform(pose.getBasis(), (pose.getOrigin() - origin) * scale);
}

/// Passes contact points on in metres and the world frame.
class InMetres final : public btDiscreteCollisionDetectorInterface::Result {
 public:
  InMetres(btManifoldResult& out, const btVector3& origin, btScalar scale)
      : out_(out), origin_(origin), scale_(scale) {}

  // The result in the world already has its identifiers.
  void setShapeIdentifiersA(int, int) override {}
  void setShapeIdentifiersB(int, int) override {}
  void addContactPoint(const btVector3& normal_on_b, const btVector3& point, btScalar gap) override {
    out_.addContactPoint(normal_on_b, origin_ + point / scale_, gap / scale_);
  }

 private:
  btManifoldResult& out_;
  btVector3 origin_;
  btScalar scale_;
};

class ConvexPair final : public btActivatingCollisionAlgorithm {
 public:
  ConvexPair(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
             const btCollisionObjectWrapper* b, btConvexPenetrationDepthSolver* depth_solver)
      : btActivatingCollisionAlgorithm(info, a, b),
        depth_solver_(depth_solver),
        manifold_(info.m_manifold),
        owns_manifold_(info.m_manifold == nullptr) {}
  ~ConvexPair() override {
    if (owns_manifold_ && manifold_ != nullptr) m_dispatcher->releaseManifold(manifold_);
  }
  ConvexPair(const ConvexPair&) = delete;
  ConvexPair& operator=(const ConvexPair&) = delete;

  void processCollision(const btCollisionObjectWrapper* a, const btCollisionObjectWrapper* b,
                        const btDispatcherInfo&, btManifoldResult* out) override {
    if (manifold_ == nullptr)
      manifold_ = m_dispatcher->getNewManifold(a->getCollisionObject(), b->getCollisionObject());
    out->setPersistentManifold(manifold_);
    add_closest_point(*a, *b, *out);
    if (owns_manifold_) out->refreshContactPoints();
  }

  btScalar calculateTimeOfImpact(btCollisionObject*, btCollisionObject*, const btDispatcherInfo&,
                                 btManifoldResult*) override {
    return 1;  // PhasedWorld sweeps bodies without it
  }

  void getAllContactManifolds(btManifoldArray& manifolds) override {
    if (owns_manifold_ && manifold_ != nullptr) manifolds.push_back(manifold_);
  }

 private:
  void add_closest_point(const btCollisionObjectWrapper& a, const btCollisionObjectWrapper& b,
                         btManifoldResult& out) const {
    // Bullet scales shapes that are not constant.
    auto* shape_a = static_cast<btConvexShape*>(const_cast<btCollisionShape*>(a.getCollisionShape()));
    auto* shape_b = static_cast<btConvexShape*>(const_cast<btCollisionShape*>(b.getCollisionShape()));
    const btScalar scale = units_per_metre(*shape_a, *shape_b);
    const btUniformScalingShape scaled_a(shape_a, scale), scaled_b(shape_b, scale);
    btVoronoiSimplexSolver simplex_solver;
    btGjkPairDetector detector(&scaled_a, &scaled_b, &simplex_solver, depth_solver_);
    btGjkPairDetector::ClosestPointInput input;
    const btScalar farthest =
        scaled_a.getMargin() + scaled_b.getMargin() +
        scale * (manifold_->getContactBreakingThreshold() + out.m_closestPointDistanceThreshold);
    input.m_maximumDistanceSquared = farthest * farthest;
    const btVector3 origin = a.getWorldTransform().getOrigin();
    input.m_transformA = scaled(a.getWorldTransform(), origin, scale);
    input.m_transformB = scaled(b.getWorldTransform(), origin, scale);
    InMetres in_metres(out, origin, scale);
    detector.getClosestPoints(input, in_metres, nullptr);
  }

  btConvexPenetrationDepthSolver* depth_solver_;
  btPersistentManifold* manifold_;
  bool owns_manifold_;
};

/// Returns whether Bullet has a closed form for these two shapes.
bool has_closed_form(int type_a, int type_b) {
  const auto is_round = [](int type) {
    return type == CAPSULE_SHAPE_PROXYTYPE || type == SPHERE_SHAPE_PROXYTYPE;
  };
  return is_round(type_a) && is_round(type_b);
}

}  // namespace

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getCollisionAlgorithmCreateFunc(int type_a,
                                                                                        int type_b) {
  return in_fitting_units(btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(type_a, type_b),
                          type_a, type_b);
}

btCollisionAlgorithmCreateFunc* CollisionConfiguration::getClosestPointsAlgorithmCreateFunc(int type_a,
                                                                                            int type_b) {
  return in_fitting_units(
      btDefaultCollisionConfiguration::getClosestPointsAlgorithmCreateFunc(type_a, type_b), type_a, type_b);
}

btCollisionAlgorithmCreateFunc* CollisionConfiguration::in_fitting_units(
    btCollisionAlgorithmCreateFunc* found, int type_a, int type_b) {
  if (found != m_convexConvexCreateFunc || has_closed_form(type_a, type_b)) return found;
  create_pair_.depth_solver = m_pdSolver;
  return &create_pair_;
}

btCollisionAlgorithm* CollisionConfiguration::CreatePair::CreateCollisionAlgorithm(
    btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* a,
    const btCollisionObjectWrapper* b) {
  void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(ConvexPair));
  return new (memory) ConvexPair(info, a, b, depth_solver);
}

}  // namespace prosector::rigid
