#pragma once
// Conversion between Bullet's float vectors and ours. Only for .cpp files of the mechanics.
//
// Bullet's collision functions have tolerances of fixed lengths, up to a hundredth of a unit of length. They
// suit bodies of a few units. With metres, balls of a centimetre pass through plates without a contact.
// Bullet's unit is therefore 1/64 m here. A power of two, so that all conversions are exact.

#include <btBulletDynamicsCommon.h>

#include "common/math.h"

namespace prosector::rigid {

inline constexpr double units = 64;           // of length in Bullet, per metre
inline constexpr double near_contact = 0.02;  // m: gap up to which bodies are searched for contact points

// ---- Directions, angular velocities
inline btVector3 to_bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
inline Vec3 from_bullet(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

// ---- Lengths, velocities, accelerations
inline btVector3 scaled(const Vec3& v) {
  return to_bullet(Vec3(units * v));
}
inline btScalar scaled(double length) {
  return static_cast<btScalar>(units * length);
}
inline btTransform scaled(const Pose& pose) {
  const Quat& q = pose.q;
  return btTransform(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                  static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())),
                     scaled(pose.p));
}
inline Vec3 unscaled(const btVector3& v) {
  return from_bullet(v) / units;
}
inline double unscaled(btScalar length) {
  return static_cast<double>(length) / units;
}
inline Pose unscaled(const btTransform& t) {
  const btQuaternion q = t.getRotation();
  return {unscaled(t.getOrigin()), Quat(static_cast<double>(q.w()), static_cast<double>(q.x()),
                                        static_cast<double>(q.y()), static_cast<double>(q.z()))
                                       .normalized()};
}

// ---- Masses of bodies. Impulses keep their values in N·s, since Bullet limits the effect of rolling
// friction to impulses of 1.
inline btScalar scaled_mass(double mass) {
  return static_cast<btScalar>(mass / units);
}
/// Returns a moment of inertia (kg·m²) in Bullet's units.
inline btVector3 scaled_inertia(const Vec3& inertia) {
  return scaled(inertia);  // times the square of the length, over the mass
}

}  // namespace prosector::rigid
