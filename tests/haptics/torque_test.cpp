// Torque: what a tool's tip does to the hand that holds it, on arms whose motors turn the stylus, and what
// turns do on arms whose motors don't.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "client/haptics/haptic_loop.h"
#include "common/rotation.h"
#include "drivers/arms/dhd.h"
#include "tests/haptics/haptic_case.h"
#include "twins/arms/wrist_model.h"

namespace prosector {
namespace {

constexpr double lever = 0.1;         // m: from the grip to the tool's tip, along the stylus
constexpr double aimed_turn = -0.15;  // rad about x: the tip goes down
constexpr int cycles_a_message = 16;  // as often as a server tells of planes, about

/// The floor is y = 0, and a tool's tip lies on it that reaches forward from a grip at the same height.
ContactPlane floor_below_the_tip(double stiffness) {
  ContactPlane plane;
  plane.id = 1;
  plane.arm = plane.point = {0, 0, -lever};
  plane.stiffness = plane.tangential = stiffness;
  plane.friction = 0.3;
  return plane;
}

struct TurnResult {
  double torque = 0, turn = 0, force = 0;  // N·m, rad, N: means of the last second, about x and along y
  double ripple = 0;                       // rad
  double least_energy = 0;                 // J, with what a torque that isn't shown would have taken
  Vec3 place = Vec3::Zero();               // m: of the grip at last
  Quat turned = Quat::Identity();
};

/// A hand holds the grip where it is and turns the tip into the floor.
TurnResult turn_into_the_floor(double stiffness, const HandImpedance& hand, bool turns) {
  const ContactPlane plane = floor_below_the_tip(stiffness);
  ArmModel arm({.mass = 0.2, .damping = 0.3, .quantum = 1e-5, .peak_force = 12}, hand, Vec3::Zero());
  WristModel wrist({}, hand, Quat::Identity());
  HapticLoop loop(dhd_limits());
  TurnResult out;
  double least = std::numeric_limits<double>::infinity(), most = -least, unshown = 0;
  constexpr int cycles = 5000, from = 4000;
  for (int k = 0; k < cycles; ++k) {
    const double t = k * dt;
    if (k % cycles_a_message == 0) loop.take({&plane, 1}, t);
    ArmReading reading;
    reading.valid = true;
    reading.turns = turns;
    reading.stylus = {arm.measured(), wrist.measured()};
    arm.set_force(loop.cycle(reading, t + dt));
    wrist.set_torque(loop.torque());
    const double share = std::clamp(t - 1, 0., 1.), before = turn(Quat::Identity(), wrist.orientation()).x();
    arm.advance(dt, Vec3::Zero(), Vec3::Zero());
    wrist.advance(dt, rotated_by({share * aimed_turn, 0, 0}));
    const double now = turn(Quat::Identity(), wrist.orientation()).x();
    unshown -= (lever * std::cos(now) * arm.force().y() - wrist.torque().x()) * (now - before);
    out.least_energy = std::min(out.least_energy, arm.energy() + wrist.energy() + unshown);
    if (k < from) continue;
    out.torque += wrist.torque().x() / (cycles - from);
    out.force += arm.force().y() / (cycles - from);
    out.turn += now / (cycles - from);
    least = std::min(least, now);
    most = std::max(most, now);
  }
  out.ripple = most - least;
  out.place = arm.position();
  out.turned = wrist.orientation();
  return out;
}

/// What the floor does to the tip where the hand is at last.
double true_force(const TurnResult& at, double stiffness) {
  return -stiffness * Vec3(at.place + at.turned * Vec3(0, 0, -lever)).y();
}

class Tips : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(NewtonsAMetre, Tips, testing::Values(30, 100, 300, 1000, 3000));

TEST_P(Tips, TurnTheHandAsHardAsTheyArePressedAndStayStill) {
  const double stiffness = GetParam();
  for (const HandImpedance& hand : {light_hand, medium_hand}) {
    const TurnResult result = turn_into_the_floor(stiffness, hand, true);
    const double torsion = stiffness * lever * lever;
    const double share = std::min(1., dhd_limits().torsion / torsion);
    std::printf(
        "%4.0f N/m: %.2f mN·m at %.4f rad, force %.3f N (%.3f of true), ripple %.5f rad, energy %.4f mJ\n",
        stiffness, 1e3 * result.torque, result.turn, result.force,
        result.force / true_force(result, stiffness), 1e3 * result.ripple, 1e3 * result.least_energy);
    EXPECT_NEAR(result.force / true_force(result, stiffness), 1, 0.05);
    EXPECT_NEAR(result.torque / (share * lever * result.force), 1, 0.05);
    EXPECT_LT(result.ripple, 2e-3);
    EXPECT_GT(result.least_energy, -2e-4);
    EXPECT_GT(result.turn, aimed_turn) << "it is held back";
  }
}

TEST(Torque, WhereNoMotorTurnsTheStylusTurningIsNoEnergyThatIsMissing) {
  const ContactPlane plane = floor_below_the_tip(500);
  HapticLoop loop(dhd_limits());
  double least = 0, expected = 0, felt = 0;
  for (int k = 0; k < 6000; ++k) {
    const double t = k * dt, angle = t < 1 ? 0 : -0.1 * (1 - std::cos(2 * (t - 1)));
    if (k % cycles_a_message == 0) loop.take({&plane, 1}, t);
    ArmReading reading;
    reading.valid = true;
    reading.stylus = {Vec3::Zero(), rotated_by({angle, 0, 0})};
    felt = loop.cycle(reading, t + dt).y();
    EXPECT_EQ(loop.torque(), Vec3::Zero());
    expected = 500 * lever * std::sin(-angle);
    least = std::min(least, loop.energy_level());
    if (t > 1) {
      EXPECT_NEAR(felt, expected, 0.02 + 0.02 * expected) << t;
    }
  }
  EXPECT_GT(least, -1e-5);
}

TEST(Torque, ForceActsAtTheStylusPointHoweverFarThatIsFromTheWrist) {
  // The wrist is 10 cm behind the stylus' point. A turn about that point moves the wrist and does no work.
  const Vec3 grip(0, 0, -0.1);
  ContactPlane weight;
  weight.id = 1;
  weight.holds = true;
  weight.arm = grip;
  weight.force = {0, -2, 0};
  HapticLoop loop(dhd_limits(), {}, grip);
  for (int k = 0; k < 3000; ++k) {
    const double t = k * dt;
    if (k % cycles_a_message == 0) loop.take({&weight, 1}, t);
    const Quat q = rotated_by({0.3 * std::sin(3 * t), 0, 0});
    ArmReading reading;
    reading.valid = reading.turns = true;
    reading.stylus = {-(q * grip), q};
    loop.cycle(reading, t + dt);
  }
  EXPECT_NEAR(loop.force().y(), -2, 1e-6);
  EXPECT_NEAR(loop.torque().norm(), 0, 1e-6);
  EXPECT_LT(loop.energy().given + loop.energy().taken, 1e-9);
}

}  // namespace
}  // namespace prosector
