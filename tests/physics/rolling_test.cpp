// Rolling resistance, against a ball on a slope: it speeds up by (g sin θ − c g cos θ) / (1 + I/mR²).

#include "server/physics/mechanics/rigid/rolling.h"

#include <gtest/gtest.h>

#include <cmath>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double g = 9.81, radius = 0.04;

/// Makes an empty room that leans so that what is in it rolls along x.
SceneDesc slope(double sine, bool on_the_rooms_floor) {
  SceneDesc scene;
  scene.gravity = g * Vec3(sine, -std::sqrt(1 - sine * sine), 0);
  if (on_the_rooms_floor) {
    scene.room = RoomDesc{};
  } else {
    scene.rigid.push_back(part_body("plate", "box", {10, 0.1, 1}, {0, -0.05, 0}));
    scene.rigid.back().fixed = true;
  }
  return scene;
}

SceneDesc rigid_ball(double sine, double resistance, bool on_the_rooms_floor) {
  SceneDesc scene = slope(sine, on_the_rooms_floor);
  scene.rigid.push_back(part_body("ball", "sphere", Vec3::Constant(2 * radius), {0, radius, 0}));
  scene.rigid.back().contact.rolling_resistance = resistance;
  return scene;
}

/// Makes a cube of tissue that collides as the ball around it.
SceneDesc soft_ball(double sine, double resistance, bool on_the_rooms_floor) {
  SceneDesc scene = slope(sine, on_the_rooms_floor);
  SoftDesc cube = block("ball");
  cube.geometry.size = Vec3::Constant(2 * radius);
  cube.pose.p.y() =
      std::sqrt(3.0) * radius + 0.025;  // it begins in an equilibrium where something near carries it
  cube.material.youngs_modulus = 1e5;
  cube.material.damping_mass = 0;
  cube.contact.collision = Fidelity::sphere;
  cube.contact.rolling_resistance = resistance;
  scene.soft.push_back(cube);
  return scene;
}

Vec3 middle(const Simulation& simulation, BodyId body) {
  if (simulation.kind(body) == BodyKind::rigid) return simulation.rigid_state(body).pose.p;
  const VecX& x = simulation.soft_state(body).motion.x;
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

/// Returns how fast the ball speeds up once it has settled, m/s².
double acceleration(const SceneDesc& scene) {
  Simulation simulation(scene, options());
  const auto ball = static_cast<BodyId>(simulation.body_count() - 1);
  const int part = 30;  // ticks
  std::array<double, 3> at{};
  for (int i = 0; i < part; ++i) simulation.step({});
  for (double& x : at) {
    x = middle(simulation, ball).x();
    for (int i = 0; i < part; ++i) simulation.step({});
  }
  const double seconds = part / scene.tick_rate;
  return (at[2] - 2 * at[1] + at[0]) / (seconds * seconds);
}

struct Case {
  const char* name;
  SceneDesc (*scene)(double, double, bool);
  bool on_the_rooms_floor;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class Rolling : public testing::TestWithParam<Case> {};

// Free of any resistance it rolls 0.14 m or more in these two seconds; tissue damps itself.
TEST_P(Rolling, ABallStaysOnASlopeThatIsLessThanItsResistance) {
  const auto& [name, scene, floor] = GetParam();
  const auto way = [&, scene = scene, floor = floor](double resistance) {
    Simulation simulation(scene(0.01, resistance, floor), options());
    for (int i = 0; i < 120; ++i) simulation.step({});
    return std::abs(middle(simulation, static_cast<BodyId>(simulation.body_count() - 1)).x());
  };
  EXPECT_LT(way(0.1), 0.01);
  EXPECT_GT(way(0), 0.02);
}

INSTANTIATE_TEST_SUITE_P(, Rolling,
                         testing::Values(Case{"RigidOnAPlate", rigid_ball, false},
                                         Case{"RigidOnTheFloor", rigid_ball, true},
                                         Case{"SoftOnAPlate", soft_ball, false},
                                         Case{"SoftOnTheFloor", soft_ball, true}),
                         [](const auto& info) { return std::string(info.param.name); });

// Bullet's rolling friction takes 6 % too much at a coefficient of 0.02, and 20 % at 0.05.
TEST(RigidRolling, ABallOnASlopeSpeedsUpByWhatResistanceLeaves) {
  const double sine = 0.1, cosine = std::sqrt(1 - sine * sine), inertia = 0.4;
  for (const bool floor : {false, true}) {
    const double whole = g * sine / (1 + inertia), free = acceleration(rigid_ball(sine, 0, floor));
    EXPECT_NEAR(free, whole, 0.03 * whole) << floor;
    for (const double c : {0.005, 0.01, 0.02}) {
      const double taken = c * g * cosine / (1 + inertia);
      EXPECT_NEAR(free - acceleration(rigid_ball(sine, c, floor)), taken, 0.07 * taken) << c << floor;
    }
  }
}

TEST(RollingLead, IsAheadAndGrowsWithTheSpeedUpToTheWhole) {
  const Vec3 up = Vec3::UnitY();
  double before = 0;
  for (const double spin : {0.0, 0.1, 0.3, 1.0, 30.0}) {
    const rigid::RollingSide ball{0.1, {0, radius, 0}, {0, 0, -spin}};  // rolls along x
    const Vec3 lead = rigid::rolling_lead(ball, {}, Vec3::Zero(), up);
    EXPECT_GE(lead.x(), before);
    EXPECT_LT(Vec3(lead - lead.x() * Vec3::UnitX()).norm(), 1e-15);
    before = lead.x();
  }
  EXPECT_NEAR(before, 0.1 * radius, 1e-12);
}

TEST(RollingLead, IsTheSameWhicheverBodyComesFirst) {
  const rigid::RollingSide a{0.1, {0, radius, 0}, {0.5, 2, -3}}, b{0.03, {0, -0.1, 0}, {-1, 0, 0.4}};
  const Vec3 one = rigid::rolling_lead(a, b, Vec3::Zero(), Vec3::UnitY());
  const Vec3 other = rigid::rolling_lead(b, a, Vec3::Zero(), -Vec3::UnitY());
  EXPECT_GT(one.norm(), 0);
  EXPECT_LT(Vec3(one.normalized() - other.normalized()).norm(), 1e-12);
}

TEST(RollingLead, NothingLeadsWhereNothingRolls) {
  const rigid::RollingSide still{0.1, {0, radius, 0}, Vec3::Zero()}, spins{0.1, {0, radius, 0}, {0, 5, 0}};
  EXPECT_EQ(rigid::rolling_lead(still, {}, Vec3::Zero(), Vec3::UnitY()), Vec3(0, 0, 0));
  EXPECT_EQ(rigid::rolling_lead(spins, {}, Vec3::Zero(), Vec3::UnitY()), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace prosector::test
