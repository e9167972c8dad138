#include "server/physics/mechanics/rigid/sweep.h"

#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace prosector::rigid {
namespace {

constexpr double least_sample = 0.0005;  // m: least distance of two samples of a path
constexpr int samples_per_half = 2;      // of the half thickness
constexpr double most_samples = 4000;    // of one path
constexpr int bisections = 5;            // of the interval between two samples

/// The objects near a body's path that may stop the body.
class Obstacles final : public btBroadphaseAabbCallback {
 public:
  Obstacles(btRigidBody& body, btOverlapFilterCallback& filter) : body_(body), filter_(filter) {}

  bool process(const btBroadphaseProxy* proxy) override {
    auto* other = static_cast<btCollisionObject*>(proxy->m_clientObject);
    auto* own = body_.getBroadphaseHandle();
    if (other != &body_ && filter_.needBroadphaseCollision(own, const_cast<btBroadphaseProxy*>(proxy)) &&
        body_.checkCollideWith(other) && other->checkCollideWith(&body_))
      found_.push_back(other);
    return true;
  }
  const std::vector<btCollisionObject*>& found() const { return found_; }

 private:
  btRigidBody& body_;
  btOverlapFilterCallback& filter_;
  std::vector<btCollisionObject*> found_;
};

/// Depth of a body in an object, among the points that move into the object fast enough.
struct Overlap final : btCollisionWorld::ContactResultCallback {
  // drift: the object's velocity; least: m/s, of a point of the body along the contact normal.
  Overlap(const btRigidBody& body, const btVector3& drift, double least)
      : body_(body), drift_(drift), least_(static_cast<btScalar>(least)) {}

  btScalar addSingleResult(btManifoldPoint& p, const btCollisionObjectWrapper*, int, int,
                           const btCollisionObjectWrapper*, int, int) override {
    const btVector3 arm = p.getPositionWorldOnB() - body_.getWorldTransform().getOrigin(),
                    velocity = body_.getVelocityInLocalPoint(arm) - drift_;
    if (std::abs(p.m_normalWorldOnB.dot(velocity)) >= least_)
      depth = std::max(depth, -static_cast<double>(p.getDistance()));
    return 0;
  }
  double depth = 0;  // m

 private:
  const btRigidBody& body_;
  btVector3 drift_;
  btScalar least_;
};

btVector3 velocity_of(const btCollisionObject& object) {
  const btRigidBody* body = btRigidBody::upcast(&object);
  return body && body->isActive() ? body->getLinearVelocity() : btVector3(0, 0, 0);
}

/// Returns a bound of the speed of the body's points relative to something that moves with `drift`, m/s.
double fastest_point(const btRigidBody& body, const btVector3& drift) {
  return static_cast<double>((body.getLinearVelocity() - drift).length() +
                             body.getAngularVelocity().length() *
                                 body.getCollisionShape()->getAngularMotionDisc());
}

/// A body's path in a step, relative to one obstacle.
class Path {
 public:
  Path(btCollisionWorld& world, btRigidBody& body, btCollisionObject& obstacle, double half_thickness,
       double h)
      : world_(world),
        body_(body),
        obstacle_(obstacle),
        start_(body.getWorldTransform()),
        drift_(velocity_of(obstacle)),
        half_(half_thickness),
        h_(h) {}

  double free_share() {
    const double length = h_ * fastest_point(body_, drift_);
    if (!(length >= half_)) return 1;
    if (const double at_start = depth_after(0, 0); at_start > 0) allowed_ = at_start + half_ / 2;
    const double step = std::max(least_sample, half_ / samples_per_half);
    const int samples = static_cast<int>(std::ceil(std::min(length / step, most_samples)));
    for (int k = 1; k <= samples; ++k)
      if (is_stopped(static_cast<double>(k) / samples)) return first_stop(k, samples);
    return 1;
  }

 private:
  bool is_stopped(double share) { return depth_after(share, half_) > allowed_; }

  /// Returns the depth in the obstacle after that share of the step, m, of points that approach it by at
  /// least `least` (m) along the contact normal in the step.
  double depth_after(double share, double least) {
    const auto t = static_cast<btScalar>(share * h_);
    btTransform at;
    btTransformUtil::integrateTransform(start_, body_.getLinearVelocity() - drift_,
                                        body_.getAngularVelocity(), t, at);
    body_.setWorldTransform(at);
    Overlap overlap(body_, drift_, least / h_);
    world_.contactPairTest(&body_, &obstacle_, overlap);
    body_.setWorldTransform(start_);
    return overlap.depth;
  }

  double first_stop(int sample, int samples) {
    double before = static_cast<double>(sample - 1) / samples, after = static_cast<double>(sample) / samples;
    for (int i = 0; i < bisections; ++i) {
      const double middle = (before + after) / 2;
      (is_stopped(middle) ? after : before) = middle;
    }
    return after;
  }

  btCollisionWorld& world_;
  btRigidBody& body_;
  btCollisionObject& obstacle_;
  btTransform start_;
  btVector3 drift_;
  double half_, h_;
  double allowed_ = 0;  // m: depth beyond which the obstacle stops the body
};

/// Returns the fraction in (0, 1] of the body's motion over `h` s after which it first meets something.
double unobstructed_share(btCollisionWorld& world, btOverlapFilterCallback& filter, btRigidBody& body,
                          double half_thickness, double h) {
  btTransform end;
  btTransformUtil::integrateTransform(body.getWorldTransform(), body.getLinearVelocity(),
                                      body.getAngularVelocity(), static_cast<btScalar>(h), end);
  btVector3 lo, hi, end_lo, end_hi;
  body.getAabb(lo, hi);
  body.getCollisionShape()->getAabb(end, end_lo, end_hi);
  lo.setMin(end_lo);
  hi.setMax(end_hi);
  Obstacles obstacles(body, filter);
  world.getBroadphase()->aabbTest(lo, hi, obstacles);
  double share = 1;
  for (btCollisionObject* obstacle : obstacles.found())
    share = std::min(share, Path(world, body, *obstacle, half_thickness, h).free_share());
  return share;
}

}  // namespace

void StoppedBodies::sweep(btRigidBody& body, double half_thickness) {
  if (fastest_point(body, btVector3(0, 0, 0)) * h_ < half_thickness) return;
  const double share = unobstructed_share(world_, filter_, body, half_thickness, h_);
  if (share < 1)
    stopped_.push_back(
        {&body, body.getLinearVelocity(), body.getAngularVelocity(), static_cast<btScalar>(share)});
}

void StoppedBodies::slow_down() const {
  for (const Stopped& s : stopped_) {
    s.body->setLinearVelocity(s.share * s.linear);
    s.body->setAngularVelocity(s.share * s.angular);
  }
}

void StoppedBodies::give_velocities_back() const {
  for (const Stopped& s : stopped_) {
    s.body->setLinearVelocity(s.linear);
    s.body->setAngularVelocity(s.angular);
  }
}

}  // namespace prosector::rigid
