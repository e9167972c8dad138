#pragma once
// The force of one contact plane on a hand that moves, with its friction and its take-over of newer planes.

#include "client/haptics/hand_motion.h"
#include "common/contact_plane.h"

namespace prosector {

/// What hands feel of a plane in one cycle.
struct PlaneForce {
  Vec3 force = Vec3::Zero();      // N, on the hand
  Vec3 point = Vec3::Zero();      // m, room: where it acts
  Mat3 stiffness = Mat3::Zero();  // N/m: of the springs that act, by how much force falls along a way
  double stored = 0;              // J, in the plane's springs
  // W, that the surface gives by moving, besides what this hand does to it. What is held may give any energy:
  // it has weight, and others move it.
  double power = 0;
};

class PlaneContact {
 public:
  /// Begins with a plane that was not felt before. Should the hand be pressed there already, that force comes
  /// over `spread` s.
  PlaneContact(const ContactPlane& plane, double spread);

  std::uint32_t id() const { return plane_.id; }
  bool gone() const { return gone_ && spread_left_ <= 0; }

  /// Takes the same contact's newer plane. What the force would jump by is spread over `spread` s.
  void renew(const ContactPlane& plane, double spread);
  /// Lets the contact go: its force fades over `spread` s.
  void end(double spread);

  /// Returns the force on a hand at `hand` whose origin moves like that, and goes on by dt s.
  PlaneForce advance(const Pose& hand, const HandMotion& motion, double dt);

 private:
  Vec3 damped(const Vec3& force, const Vec3& velocity) const;
  Mat3 stiffness_under(const Vec3& force) const;
  Vec3 elastic(const Vec3& p) const;
  Vec3 friction(const Vec3& p, double normal_force) const;

  ContactPlane plane_;
  double age_ = 0;                       // s, of the plane
  Vec3 anchor_;                          // m, room: where friction would hold with no force (the proxy)
  bool anchored_ = false;                // the anchor is known: it was touched since the plane came
  bool gone_ = false;                    // ended: only what is left to spread acts
  bool fresh_ = true;                    // it was not felt yet as it is now
  Vec3 last_ = Vec3::Zero();             // N, as it was felt
  Vec3 jump_ = Vec3::Zero();             // N: what the force lacked of that when the plane came
  double spread_ = 0, spread_left_ = 0;  // s
};

}  // namespace prosector
