#include "tests/haptics/press_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "client/haptics/haptic_loop.h"

namespace prosector {
namespace {

constexpr double surface = 1;  // m: height of the plane
constexpr double seconds = 5, measured = 1;
constexpr int cycles_a_message = 16;  // as often as a server tells of planes, about

}  // namespace

HeldArmOptions pressing_hand() {
  HeldArmOptions out;
  out.room_arm = {Vec3(0.1, surface, -0.2), Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()))};
  const auto at = [&](double height) { return Pose{Vec3(0.11, surface + height, -0.19), out.room_arm.q}; };
  out.script.add(0, 0, at(0.02));
  out.script.add(0, 1, at(0.02));
  out.script.add(0, 2, at(-0.01));
  return out;
}

PressResult press(Arm& arm, const HeldArm& held, double stiffness, std::int64_t& now_ns,
                  const std::function<void(std::int64_t now_ns)>& tick, bool field) {
  ContactPlane plane;
  plane.id = 1;
  plane.point = Vec3(0.11, surface, -0.19);
  plane.stiffness = plane.tangential = stiffness;
  HapticLoop loop(arm.limits());
  PressResult out;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  const std::int64_t start = now_ns;
  const int cycles = static_cast<int>(1000 * seconds), from = static_cast<int>(1000 * (seconds - measured));
  for (int k = 0; k < cycles; ++k) {
    now_ns += ms;
    tick(now_ns);
    const double time = 1e-9 * static_cast<double>(now_ns - start);
    if (k % cycles_a_message == 0) loop.take({&plane, 1}, time);
    const Vec3 force = loop.cycle(arm.read(), time);
    arm.set_field(force, field ? loop.stiffness() : Mat3(Mat3::Zero()));
    out.least_energy = std::min(out.least_energy, held.model().energy());
    if (k < from) continue;
    const double depth = surface - (held.room_arm() * held.model().position()).y();
    out.force += (held.room_arm().q * held.model().force()).y() / (cycles - from);
    out.depth += depth / (cycles - from);
    least = std::min(least, depth);
    most = std::max(most, depth);
  }
  out.ripple = most - least;
  return out;
}

void expect_felt(const PressResult& pressed, double stiffness) {
  std::printf("%4.0f N/m: %.3f N at %.3f mm (%.3f of it), ripple %.4f mm, least energy %.4f mJ\n", stiffness,
              pressed.force, 1e3 * pressed.depth, pressed.force / pressed.depth / stiffness,
              1e3 * pressed.ripple, 1e3 * pressed.least_energy);
  EXPECT_GT(pressed.depth, 1e-3);
  EXPECT_NEAR(pressed.force / pressed.depth / stiffness, 1, 0.03);
  EXPECT_LT(pressed.ripple, 3e-4);
  EXPECT_GT(pressed.least_energy, -2e-4);
}

}  // namespace prosector
