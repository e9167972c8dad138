#include "client/haptics/plane_contact.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr double max_extrapolation = 0.1;  // s: a surface is extrapolated for at most this time
constexpr double sticking = 1 - 1e-9;      // fraction of the friction limit above which the contact slides

Vec3 along(const Vec3& v, const Vec3& normal) {
  return v - v.dot(normal) * normal;
}

}  // namespace

PlaneContact::PlaneContact(const ContactPlane& plane, double spread)
    : plane_(plane), anchor_(plane.point), spread_(spread), spread_left_(spread) {}

void PlaneContact::renew(const ContactPlane& plane, double spread) {
  plane_ = plane;
  age_ = 0;
  gone_ = false;
  anchored_ = false;
  fresh_ = true;
  spread_ = spread_left_ = spread;
}

void PlaneContact::end(double spread) {
  if (gone_) return;
  gone_ = fresh_ = true;
  spread_ = spread_left_ = spread;
}

PlaneForce PlaneContact::advance(const Pose& hand, const HandMotion& motion, double dt) {
  PlaneForce out;
  out.point = hand * plane_.arm;
  const Vec3 velocity = motion.at(out.point - hand.p);
  age_ += dt;
  const Vec3& n = plane_.normal;
  if (!gone_) {
    const Vec3 moved = plane_.velocity * dt;
    if (anchored_ && age_ < max_extrapolation) anchor_ += along(moved, n);
    const Vec3 force = elastic(out.point);
    const double pressed = force.dot(n);
    anchored_ = plane_.tangential > 0 && (pressed > 0 || plane_.holds);
    if (anchored_) anchor_ = along(out.point, n) + along(force, n) / plane_.tangential;
    out.force = damped(force, velocity);
    if (pressed > 0 || plane_.holds) out.stiffness = stiffness_under(force);
    if (plane_.holds) {
      out.power = std::max(0., out.force.dot(velocity));
    } else {
      if (plane_.stiffness > 0) out.stored = pressed * pressed / (2 * plane_.stiffness);
      out.power = std::max(0., out.force.dot(plane_.velocity));
    }
  }
  if (std::exchange(fresh_, false)) jump_ = last_ - out.force;
  if (spread_left_ > 0) {
    spread_left_ = std::max(0., spread_left_ - dt);
    out.force += spread_left_ / spread_ * jump_;
  }
  // A unilateral plane doesn't pull, not even while a jump is spread.
  if (const double pull = out.force.dot(n); pull < 0 && !plane_.holds) out.force -= pull * n;
  last_ = out.force;
  return out;
}

/// Returns the force with the plane's damping. Damping never makes a unilateral contact pull.
Vec3 PlaneContact::damped(const Vec3& force, const Vec3& velocity) const {
  const Vec3& n = plane_.normal;
  const double pressed = force.dot(n);
  if (pressed <= 0 && !plane_.holds) return force;
  const double all = pressed - plane_.damping * (velocity - plane_.velocity).dot(n);
  return along(force, n) + (plane_.holds ? all : std::max(0., all)) * n;
}

/// Returns the stiffness at this force: without the tangential part if the contact slides.
Mat3 PlaneContact::stiffness_under(const Vec3& force) const {
  const Mat3 across = plane_.normal * plane_.normal.transpose();
  const bool sticks = plane_.holds || along(force, plane_.normal).norm() <
                                          sticking * plane_.friction * force.dot(plane_.normal);
  return plane_.stiffness * across + (sticks ? plane_.tangential : 0) * (Mat3::Identity() - across);
}

/// Returns the plane's elastic and friction force on the hand's point `p`, without damping.
Vec3 PlaneContact::elastic(const Vec3& p) const {
  const Vec3& n = plane_.normal;
  const Vec3 surface = plane_.point + plane_.velocity * std::min(age_, max_extrapolation);
  const double pressed = plane_.force.dot(n) + plane_.stiffness * (surface - p).dot(n);
  if (plane_.holds) {
    const Vec3 pulled = pressed * n + friction(p, pressed);
    const double bound = plane_.force.norm() + plane_.radius * plane_.stiffness, size = pulled.norm();
    return size > bound ? Vec3(pulled * (bound / size)) : pulled;
  }
  if (pressed <= 0) return Vec3::Zero();
  return pressed * n + friction(p, pressed);
}

/// Returns the tangential force on the point `p`, N.
Vec3 PlaneContact::friction(const Vec3& p, double normal_force) const {
  const Vec3& n = plane_.normal;
  const Vec3 sliding = anchored_
                           ? Vec3(plane_.tangential * along(anchor_ - p, n))
                           : Vec3(along(plane_.force, n) + plane_.tangential * along(plane_.point - p, n));
  if (plane_.holds) return sliding;
  const double bound = plane_.friction * normal_force, size = sliding.norm();
  return size > bound ? Vec3(sliding * (bound / size)) : sliding;
}

}  // namespace prosector
