// A scene of rigid bodies that are not fast is Bullet's: the step that is divided at the constraint stage
// gives what Bullet's undivided step gives, bit for bit, with the same contacts of convex pairs.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/physics/plain_world.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

SceneDesc tilted(double degrees) {
  SceneDesc scene;
  const double angle = degrees * std::numbers::pi / 180;
  scene.gravity = {9.81 * std::sin(angle), -9.81 * std::cos(angle), 0};
  scene.rigid = {table()};
  scene.rigid[0].geometry.parts[0].size = {40, 0.1, 40};
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
  scene.rigid.push_back(part_body("bouncer", "sphere", {0.1, 0, 0}, {0, 0.4, 1}));
  scene.rigid[0].contact.restitution = scene.rigid[2].contact.restitution = 0.7;
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
    for (int tick = 0; tick < 110; ++tick) {  // then a box of the stack falls fast enough to be swept
      simulation.step({});
      plain.step();
      for (std::size_t i = 1; i < scene.rigid.size(); ++i) {
        const RigidBodyState state = simulation.rigid_state(static_cast<BodyId>(i));
        const RigidBodyState alone = plain.state(i);
        ASSERT_EQ(state.pose.p, alone.pose.p) << name << " " << i << ", " << tick;
        ASSERT_EQ(state.linear_velocity, alone.linear_velocity) << name << " " << i << ", " << tick;
        ASSERT_EQ(state.angular_velocity, alone.angular_velocity) << name << " " << i << ", " << tick;
      }
    }
    EXPECT_GT((simulation.rigid_state(1).pose.p - scene.rigid[1].pose.p).norm(), 1e-4) << name;
  }
}

}  // namespace
}  // namespace prosector::test
