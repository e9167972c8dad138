#pragma once
// Contacts of two convex shapes, in a unit of length that suits their size.
//
// Bullet's GJK takes support points that are less than 0.01 units apart for one point, and a tetrahedron of
// less than 1e-4 cubic units / 6 for a flat one. With metres as units, bodies of a few centimetres then have
// no contact although they overlap.

#include <btBulletDynamicsCommon.h>

namespace prosector::rigid {

/// Bullet's collision algorithms. Those by GJK compute in units in which the smaller shape has a radius of 4
/// to 8. They serve all convex pairs but two boxes, two balls or capsules, and planes.
class CollisionConfiguration final : public btDefaultCollisionConfiguration {
 public:
  btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int type_a, int type_b) override;
  btCollisionAlgorithmCreateFunc* getClosestPointsAlgorithmCreateFunc(int type_a, int type_b) override;

 private:
  btCollisionAlgorithmCreateFunc* in_fitting_units(btCollisionAlgorithmCreateFunc* found, int type_a,
                                                   int type_b);

  struct CreatePair final : btCollisionAlgorithmCreateFunc {
    btConvexPenetrationDepthSolver* depth_solver = nullptr;
    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* a,
                                                   const btCollisionObjectWrapper* b) override;
  };
  CreatePair create_pair_;
};

}  // namespace prosector::rigid
