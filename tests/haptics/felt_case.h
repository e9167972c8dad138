#pragma once
// A scene, a hand in it that an arm moves, and what that hand is told after each tick.

#include <chrono>
#include <thread>

#include "server/haptics/felt_hands.h"
#include "tests/physics/scenes.h"

namespace prosector::test {

inline const HandRef feeler{somebody, right_hand};

struct FeltCase {
  explicit FeltCase(const SceneDesc& scene, const CompileOptions& compile = options())
      : simulation(scene, compile) {}

  Simulation simulation;
  FeltHands felt;
  FeltPlanes last;

  void step(const TickInput& input) {
    simulation.step(input);
    const FeelingHand hand{feeler, 5};
    last = felt.follow(simulation, {&hand, 1}).at(0);
  }
  /// Steps until all is at rest and the bodies were asked, with the same input.
  void settle(const TickInput& input) {
    for (int k = 0; k < 180; ++k) step(input);
    for (int k = 0; k < 200; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      step(input);
    }
  }
  Vec3 reported_force() const {
    Vec3 out = Vec3::Zero();
    for (const ContactPlane& plane : last.planes) out += plane.force;
    return out;
  }
  /// N/m: how the force along `direction` (unit) grows as the hand goes against it.
  double reported_stiffness(const Vec3& direction = Vec3::UnitY()) const {
    double out = 0;
    for (const ContactPlane& plane : last.planes) {
      const double along = std::pow(plane.normal.dot(direction), 2);
      out += plane.stiffness * along + plane.tangential * (1 - along);
    }
    return out;
  }
};

}  // namespace prosector::test
