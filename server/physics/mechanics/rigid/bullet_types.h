#pragma once
// Conversion between Bullet's float vectors and ours. Only for the .cpp files of this folder.

#include <btBulletDynamicsCommon.h>

#include "common/math.h"

namespace prosector::rigid {

inline btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
inline Vec3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}
inline btTransform to_bullet(const Pose& pose) {
  const Quat& q = pose.q;
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     to_bullet(pose.p));
}
inline Pose from_bullet(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  return {from_bullet(t.getOrigin()), Quat(static_cast<double>(q.w()), static_cast<double>(q.x()),
                                           static_cast<double>(q.y()), static_cast<double>(q.z()))
                                          .normalized()};
}

}  // namespace prosector::rigid
