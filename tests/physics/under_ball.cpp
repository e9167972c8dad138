#include "tests/physics/under_ball.h"

#include <cmath>

#include "tests/physics/scenes.h"

namespace prosector::test {

SceneDesc under_ball(SoftDesc tissue, double radius, const Vec3& middle) {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("ball", "sphere", {2 * radius, 0, 0}, middle)};
  scene.rigid[0].fixed = true;
  scene.rigid[0].contact.friction = 0;
  scene.soft = {std::move(tissue)};
  return scene;
}

AttachDesc bonded_below(double height) {
  // A ball so large that it is flat: 10 µm high over the middle, where the layer is four times as wide.
  const double flat = 1000, wide = 4 * height;
  return {{0, -height - flat, 0}, std::hypot(flat, wide * std::sqrt(2.0)), 1e13};
}

TickInput ball_at(const Vec3& middle) {
  TickInput input;
  input.kinematic_targets.push_back({0, {middle, Quat::Identity()}});
  return input;
}

double pressing_force(const Simulation& simulation) {
  double force = 0;
  for (const Exchange& touch : simulation.exchanges())
    force += std::abs(touch.impulse.y()) * simulation.scene().tick_rate;
  return force;
}

}  // namespace prosector::test
