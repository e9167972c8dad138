// A scene of rigid bodies only is Bullet and nothing else: the step that is cut open at the constraint stage
// gives what Bullet's own step gives, bit for bit.

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

btVector3 bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}
Vec3 ours(const btVector3& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y()), static_cast<double>(v.z())};
}

/// Boxes and spheres as the scene has them, in a world as its documentation sets one up.
class PlainWorld {
 public:
  explicit PlainWorld(const SceneDesc& scene) {
    world_.setGravity(bullet(scene.gravity));
    world_.getDispatchInfo().m_deterministicOverlappingPairs = true;
    for (const RigidDesc& desc : scene.rigid) add(desc);
  }
  ~PlainWorld() {
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  void step() { world_.stepSimulation(btScalar(1.0 / 60), 0); }
  const btRigidBody& body(std::size_t i) const { return *bodies_[i]; }

 private:
  void add(const RigidDesc& desc) {
    const Vec3 size = desc.parts[0].size;
    const double r = size.x() / 2;
    const bool sphere = desc.parts[0].shape == "sphere";
    if (sphere)
      shapes_.push_back(std::make_unique<btSphereShape>(static_cast<btScalar>(r)));
    else
      shapes_.push_back(std::make_unique<btBoxShape>(bullet(size / 2)));
    const double volume = sphere ? 4 * std::numbers::pi / 3 * r * r * r : size.prod();
    const double mass = desc.fixed ? 0 : desc.density * volume;
    const Vec3 s = size.cwiseAbs2();
    const Vec3 inertia = sphere ? Vec3::Constant(0.4 * mass * r * r)
                                : Vec3(mass / 12 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()));
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shapes_.back().get(),
                                                  bullet(inertia));
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(bullet(desc.pose.p));
    info.m_friction = static_cast<btScalar>(desc.friction);
    info.m_restitution = static_cast<btScalar>(desc.restitution);
    info.m_linearSleepingThreshold = 0.02F;
    info.m_angularSleepingThreshold = 0.1F;
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(bodies_.back().get());
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

SceneDesc tilted(double degrees) {
  SceneDesc scene;
  const double angle = degrees * std::numbers::pi / 180;
  scene.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
  scene.rigid = {table()};
  scene.rigid[0].parts[0].size = {40, 0.1, 40};
  return scene;
}

SceneDesc stack() {
  SceneDesc scene = tilted(0);
  for (int i = 0; i < 6; ++i)
    scene.rigid.push_back(
        part_body("box", "box", {0.12, 0.1, 0.08}, {0.004 * (i % 3), 0.051 + 0.103 * i, 0}));
  return scene;
}

SceneDesc slide() {
  SceneDesc scene = tilted(30);
  scene.rigid.push_back(part_body("box", "box", {0.12, 0.1, 0.08}, {0, 0.055, 0}));
  scene.rigid.push_back(part_body("bouncer", "sphere", {0.1, 0, 0}, {0, 1, 1}));
  scene.rigid[0].restitution = scene.rigid[2].restitution = 0.7;
  return scene;
}

SceneDesc roll() {
  SceneDesc scene = tilted(20);
  scene.rigid.push_back(part_body("ball", "sphere", {0.1, 0, 0}, {0, 0.05, 0}));
  scene.rigid.push_back(part_body("box", "box", {0.12, 0.1, 0.08}, {0.6, 0.05, 0}));  // which it hits
  return scene;
}

TEST(PlainBullet, RigidScenesAreBulletsBitForBit) {
  for (const auto& [name, scene] :
       {std::pair("stack", stack()), std::pair("slide", slide()), std::pair("roll", roll())}) {
    Simulation simulation(scene, options());
    PlainWorld plain(scene);
    for (int tick = 0; tick < 120; ++tick) {
      simulation.step({});
      plain.step();
      for (std::size_t i = 1; i < scene.rigid.size(); ++i) {
        const RigidBodyState state = simulation.rigid_state(static_cast<BodyId>(i));
        const btRigidBody& body = plain.body(i);
        ASSERT_EQ(state.pose.p, ours(body.getWorldTransform().getOrigin()))
            << name << " " << i << ", " << tick;
        ASSERT_EQ(state.linear_velocity, ours(body.getLinearVelocity())) << name << " " << i << ", " << tick;
        ASSERT_EQ(state.angular_velocity, ours(body.getAngularVelocity()))
            << name << " " << i << ", " << tick;
      }
    }
    EXPECT_GT((simulation.rigid_state(1).pose.p - scene.rigid[1].pose.p).norm(), 1e-4) << name;
  }
}

}  // namespace
}  // namespace prosector::test
