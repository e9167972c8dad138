#pragma once
// Force of one contact plane on a moving hand: elasticity, damping, friction, and a smooth transition to
// newer planes.

#include "client/haptics/hand_motion.h"
#include "common/contact_plane.h"

namespace prosector {

/// Force that one contact plane (local linear model of a contact) exerts on the hand in one servo cycle, with
/// its stiffness, energy and power.
struct PlaneForce {
  Vec3 force = Vec3::Zero();      // N, on the hand
  Vec3 point = Vec3::Zero();      // m, room frame: point of application
  Mat3 stiffness = Mat3::Zero();  // N/m: stiffness of the active springs with respect to displacements
  double stored = 0;              // J, elastic energy
  // W, power supplied by the surface's own motion, besides its reaction to this hand. A held body may supply
  // any energy: it has weight, and other users move it.
  double power = 0;
};

class PlaneContact {
 public:
  /// Creates the contact of a newly received plane. If the hand already penetrates the plane, the force rises
  /// over `spread` s.
  PlaneContact(const ContactPlane& plane, double spread);

  std::uint32_t id() const { return plane_.id; }
  bool gone() const { return gone_ && spread_left_ <= 0; }

  /// Replaces the contact's plane by a newly received one. The jump in force that this causes is spread over
  /// `spread` s.
  void renew(const ContactPlane& plane, double spread);
  /// Ends the contact, because the newest message no longer has its plane. The force fades over `spread` s.
  void end(double spread);

  /// Advances the contact by `dt` s, and returns the force on a hand with the room pose `hand`, whose origin
  /// moves with `motion`.
  PlaneForce advance(const Pose& hand, const HandMotion& motion, double dt);

 private:
  Vec3 damped(const Vec3& force, const Vec3& velocity) const;
  Mat3 stiffness_under(const Vec3& force) const;
  Vec3 elastic(const Vec3& p) const;
  Vec3 friction(const Vec3& p, double normal_force) const;

  ContactPlane plane_;
  double age_ = 0;            // s, since the plane was received
  Vec3 anchor_;               // m, room frame: point at which the friction force is zero (the proxy)
  bool anchored_ = false;     // the anchor is valid: there was contact since the plane was received
  bool gone_ = false;         // ended: only the rest of the spread jump acts
  bool fresh_ = true;         // plane or state changed since the last advance()
  Vec3 last_ = Vec3::Zero();  // N, last returned force
  Vec3 jump_ = Vec3::Zero();  // N: last force minus the new plane's force at the change
  double spread_ = 0, spread_left_ = 0;  // s
};

}  // namespace prosector
