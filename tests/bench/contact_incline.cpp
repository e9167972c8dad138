// Friction on an incline: below the friction angle bodies must not creep, above it they must slide with the
// theoretical acceleration. Gravity is tilted instead of the ground. The ground is driven as a kinematic
// body, which keeps the bodies awake.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double degree = std::numbers::pi / 180, g = 9.81, friction = 0.3;

Vec3 tilted(double angle) {
  return {g * std::sin(angle), -g * std::cos(angle), 0};
}

/// Returns a scene with a soft block on a rigid slope.
SceneDesc soft_on_rigid(double angle) {
  SceneDesc scene;
  scene.gravity = tilted(angle);
  scene.rigid = {test::table()};
  scene.rigid[0].geometry.parts[0].size = {40, 0.1, 20};
  scene.rigid[0].contact.friction = friction;
  scene.soft = {test::block()};
  scene.soft[0].contact.friction = friction;
  scene.soft[0].material.youngs_modulus = 2e4;
  scene.soft[0].material.damping_mass = 0;  // mass-proportional damping would slow the sliding
  return scene;
}

/// Returns a scene with a rigid block on tissue whose floor is held, and a distant kinematic body.
SceneDesc rigid_on_soft(double angle) {
  SceneDesc scene;
  scene.gravity = tilted(angle);
  scene.rigid = {test::table(), test::part_body("plate", "box", {0.06, 0.02, 0.06}, {-0.3, 0.0505, 0})};
  scene.rigid[1].contact.friction = friction;
  SoftDesc& bed = scene.soft.emplace_back(test::block("bed"));
  bed.geometry.size = {0.9, 0.04, 0.12};
  bed.geometry.cell = bed.geometry.surface_cell = 0.02;
  bed.pose.p = {0, 0.02, 0};
  bed.contact.friction = friction;
  bed.material.youngs_modulus = 2e5;
  constexpr double flat = 1000;
  bed.attach = {{{0, -flat, 0}, std::hypot(flat, 1.0), 1e13}};
  return scene;
}

struct Slope {
  const char* name;
  SceneDesc (*scene)(double angle);
  Vec3 (*place)(const Simulation& simulation);
};
const Slope slopes[] = {
    {"tissue on a rigid slope", soft_on_rigid, [](const Simulation& s) { return soft_centre(s, 1); }},
    {"rigid block on tissue", rigid_on_soft, [](const Simulation& s) { return s.rigid_state(1).pose.p; }},
};

TickInput awake() {
  return driving(0, {{0, -0.05, 0}, Quat::Identity()});
}

/// Returns the distance moved down the slope in `seconds`, after settling for `settle` s, m.
double slide(ContactRun& run, const Slope& slope, double settle, double seconds) {
  run.run(static_cast<int>(settle / run.h()), awake());
  const double from = slope.place(run.simulation()).x();
  run.run(static_cast<int>(seconds / run.h()), awake());
  return slope.place(run.simulation()).x() - from;
}

/// Returns the acceleration down the slope, m/s², from three positions, which eliminates the initial
/// velocity.
double acceleration(ContactRun& run, const Slope& slope, double seconds) {
  const int ticks = static_cast<int>(seconds / 2 / run.h());
  const double span = ticks * run.h();
  run.run(12, awake());
  const double a = slope.place(run.simulation()).x();
  run.run(ticks, awake());
  const double b = slope.place(run.simulation()).x();
  run.run(ticks, awake());
  return (slope.place(run.simulation()).x() - 2 * b + a) / (span * span);
}

}  // namespace

void incline_case(ContactRows& rows, bool quick) {
  const double limit = std::atan(friction);
  for (const Slope& slope : slopes) {
    {
      ContactRun run(slope.scene(limit - degree));
      const double crept = slide(run, slope, 1, quick ? 0.2 : 10);
      rows.add(run, fmt::format("{}, 1 degree below", slope.name),
               {"creep in 10 s", "mm", 1e3 * crept, 0, 0.1});
    }
    {
      ContactRun run(slope.scene(limit + degree));
      const double a = acceleration(run, slope, quick ? 0.2 : 1);
      // From m·g·sin(angle) − tan(φ)·m·g·cos(angle) = m·a.
      const double angle = limit + degree;
      const double phi = std::atan((g * std::sin(angle) - a) / (g * std::cos(angle)));
      rows.add(run, fmt::format("{}, 1 degree above", slope.name),
               {"friction angle from sliding", "degree", phi / degree, limit / degree, 1});
    }
  }
  ContactRun run(soft_on_rigid(30 * degree));
  rows.add(run, "tissue on a rigid slope of 30 degrees",
           {"acceleration", "m/s2", acceleration(run, slopes[0], 0.5), 2.356287, 0.02 * 2.356287});
}

}  // namespace prosector
