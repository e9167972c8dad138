#pragma once
// An arm's driver in a closed loop, in virtual time: its twin's hand presses a plane that the client's servo
// renders.

#include <cstdint>
#include <functional>

#include "drivers/device/arm.h"
#include "twins/arms/held_arm.h"

namespace prosector {

inline constexpr std::int64_t ms = 1'000'000;

/// Returns an arm that stands turned in the room, and a hand that wants to be 10 mm below a plane.
HeldArmOptions pressing_hand();
inline constexpr double hand_speed = 0.057;  // m/s: the most that it wants

struct PressResult {
  double force = 0, depth = 0;  // N, m: means of the last second, along the plane's normal
  double ripple = 0;            // m: largest less smallest depth there
  double least_energy = 0;      // J: least that the motors had taken from the hand, at any time
};

/// Presses for five seconds from `now_ns` on. `tick` lets the twin go on to the time that it is given.
/// `field`: the arm is told how force changes around a place, as the client's servo does.
PressResult press(Arm& arm, const HeldArm& held, double stiffness, std::int64_t& now_ns,
                  const std::function<void(std::int64_t now_ns)>& tick, bool field = true);

/// Expects that a press felt the plane as stiff as it is, stayed still and gave no energy.
void expect_felt(const PressResult& pressed, double stiffness);

}  // namespace prosector
