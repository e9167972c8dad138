// A silicone cylinder that hangs under its weight from one end, against its measured shape.
//
// SOFA publishes the measurement (examples/Benchmark/Accuracy): radius 19 mm, length 178 mm, 216 g, clamped
// at z = 0, gravity along −y. Its free end came to rest at (0, −119.383, 126.842) mm. Young's modulus, 75
// kPa, and Poisson's ratio, 0.49, fit an elastica through that point.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "common/anatomy/embedding.h"
#include "common/anatomy/isosurface.h"
#include "common/anatomy/stuffing.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

constexpr double cylinder_radius = 0.019, cylinder_length = 0.178, cylinder_mass = 0.216,
                 cylinder_cell = 0.008;  // m, kg
const double cylinder_volume = std::numbers::pi * cylinder_radius * cylinder_radius * cylinder_length;
const Vec3 measured(0, -0.119383, 0.126842);

SolidField cylinder() {
  const Vec3 margin = Vec3::Constant(0.002);
  return {[](const Vec3& x) {
            const double sideways = std::hypot(x.x(), x.y()) - cylinder_radius,
                         along = std::abs(x.z() - cylinder_length / 2) - cylinder_length / 2;
            const double outside = std::hypot(std::max(sideways, 0.0), std::max(along, 0.0));
            return outside > 0 ? outside : std::max(sideways, along);
          },
          {Vec3(-cylinder_radius, -cylinder_radius, 0) - margin,
           Vec3(cylinder_radius, cylinder_radius, cylinder_length) + margin}};
}

/// Returns the mean position of the nodes at the free end, m.
Vec3 free_end(const Simulation& simulation) {
  constexpr double end = 0.002;  // m
  const auto& rest = simulation.soft(0).anatomy().tets.positions;
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i].z() < cylinder_length - end) continue;
    sum += simulation.soft_state(0).motion.x.segment<3>(static_cast<Eigen::Index>(3 * i));
    ++count;
  }
  return sum / count;
}

TEST(MeasuredCylinder, HangsAsMeasured) {
  const TetMesh mesh = stuff_solid(cylinder(), cylinder_cell);
  EXPECT_NEAR(tet_quality(mesh).volume / cylinder_volume, 1, 1e-3);
  SceneDesc scene;
  SoftDesc& desc = scene.soft.emplace_back();
  desc.name = "cylinder";
  desc.configuration.model = "fem_neo_hookean";
  desc.configuration.element = "tet10";
  desc.configuration.solver = "multigrid";
  desc.configuration.newton_iterations = 10;
  desc.configuration.solver_tolerance = 1e-4;
  desc.material.youngs_modulus = 75e3;
  desc.material.poisson_ratio = 0.49;
  desc.material.density = cylinder_mass / cylinder_volume;
  desc.material.damping_mass = 5;
  desc.contact.collision = Fidelity::none;
  desc.geometry.cell = cylinder_cell;
  constexpr double flat = 1000, clamped = 1e-4;  // m: a ball so large that its surface is flat
  desc.attach = {{{0, 0, clamped - flat}, flat, 1e13}};
  CompileOptions compiled = options();
  compiled.anatomy = [&](const SoftDesc&) -> std::optional<Anatomy> {
    return embed(mesh, isosurface(cylinder(), cylinder_cell / 2)).anatomy;
  };
  Simulation simulation(scene, compiled);
  run(simulation, 60);
  const Vec3 before = free_end(simulation);
  run(simulation, 10);
  const Vec3 end = free_end(simulation);
  std::printf("free end (%.1f, %.1f, %.1f) mm, %.2f mm from the measured one\n", 1e3 * end.x(), 1e3 * end.y(),
              1e3 * end.z(), 1e3 * (end - measured).norm());
  EXPECT_LT((end - before).norm(), 1e-4) << "at rest";
  EXPECT_LT((end - measured).norm(), 4e-3);
}

}  // namespace
}  // namespace prosector::test
