#include "tests/physics/plain_world.h"

#include <btBulletDynamicsCommon.h>

#include <numbers>

#include "server/physics/mechanics/rigid/convex_pair.h"

namespace prosector::test {
namespace {

btVector3 bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 ours(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

}  // namespace

struct PlainWorld::Impl {
  btScalar h;
  rigid::CollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;

  void add(const RigidDesc& desc) {
    const Vec3 size = desc.geometry.parts[0].size;
    const double r = size.x() / 2;
    const bool sphere = desc.geometry.parts[0].shape == "sphere";
    if (sphere)
      shapes.push_back(std::make_unique<btSphereShape>(static_cast<btScalar>(r)));
    else
      shapes.push_back(std::make_unique<btBoxShape>(bullet(size / 2)));
    const double volume = sphere ? 4 * std::numbers::pi / 3 * r * r * r : size.prod();
    const double mass = desc.fixed ? 0 : desc.material.density * volume;
    const Vec3 s = size.cwiseAbs2();
    const Vec3 inertia = sphere ? Vec3::Constant(0.4 * mass * r * r)
                                : Vec3(mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()));
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shapes.back().get(),
                                                  bullet(inertia));
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(bullet(desc.pose.p));
    info.m_friction = static_cast<btScalar>(desc.contact.friction);
    info.m_restitution = static_cast<btScalar>(desc.contact.restitution);
    info.m_linearSleepingThreshold = 0.02F;
    info.m_angularSleepingThreshold = 0.1F;
    bodies.push_back(std::make_unique<btRigidBody>(info));
    world.addRigidBody(bodies.back().get());
  }
};

PlainWorld::PlainWorld(const SceneDesc& scene) : impl_(std::make_unique<Impl>()) {
  impl_->h = static_cast<btScalar>(1 / scene.tick_rate);
  impl_->world.setGravity(bullet(scene.gravity));
  impl_->world.getDispatchInfo().m_deterministicOverlappingPairs = true;
  for (const RigidDesc& desc : scene.rigid) impl_->add(desc);
}

PlainWorld::~PlainWorld() {
  for (const auto& body : impl_->bodies) impl_->world.removeRigidBody(body.get());
}

void PlainWorld::step() {
  impl_->world.stepSimulation(impl_->h, 0);
}

RigidBodyState PlainWorld::state(std::size_t body) const {
  const btRigidBody& b = *impl_->bodies[body];
  const btQuaternion q = b.getWorldTransform().getRotation();
  RigidBodyState state;
  state.pose = {ours(b.getWorldTransform().getOrigin()),
                Quat(static_cast<double>(q.w()), static_cast<double>(q.x()), static_cast<double>(q.y()),
                     static_cast<double>(q.z()))};
  state.linear_velocity = ours(b.getLinearVelocity());
  state.angular_velocity = ours(b.getAngularVelocity());
  state.asleep = b.getActivationState() == ISLAND_SLEEPING;
  return state;
}

}  // namespace prosector::test
