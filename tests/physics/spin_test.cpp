// Bodies that turn in the air, where nothing is there to brake them.

#include <gtest/gtest.h>

#include <cmath>

#include "common/anatomy/kuhn_box.h"
#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::test {
namespace {

struct Cube {
  double side = 0.1;            // m
  double youngs_modulus = 5e3;  // Pa
  const char* integrator = "implicit_euler";
  int newton_iterations = SoftDesc{}.configuration.newton_iterations,
      solver_iterations = SoftDesc{}.configuration.solver_iterations;
};

struct Spun {
  double energy = 0, momentum = 0;  // at the end, of those at the start
  double highest = 0;               // energy on the way, likewise
  double worst_converged = 0;       // residual of a tick that was told to have converged
  int converged = 0;                // ticks
};

constexpr double h = 1. / 60;  // s

Vec3 angular_momentum(const soft::SoftBody& body, const soft::SoftBodyState& state, const Vec3& centre) {
  Vec3 sum = Vec3::Zero();
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    sum += body.node_mass()[i] *
           (state.motion.x.segment<3>(3 * i) - centre).cross(Vec3(state.motion.v.segment<3>(3 * i)));
  return sum;
}

/// Corotated by `spin` (rad/s) about an axis aslant, without damping, for so many ticks.
Spun spin_cube(const Cube& cube, double spin, int ticks) {
  SoftDesc desc;
  desc.name = "cube";
  desc.configuration.integrator = cube.integrator;
  desc.material.youngs_modulus = cube.youngs_modulus;
  desc.configuration.newton_iterations = cube.newton_iterations;
  desc.configuration.solver_iterations = cube.solver_iterations;
  desc.material.damping_mass = desc.material.damping_stiffness = 0;
  Anatomy anatomy;
  anatomy.tets = kuhn_box(Vec3::Constant(cube.side), 3, 3, 3);
  soft::SoftBody body(desc, std::move(anatomy));
  soft::SoftBodyState state = body.initial_state();
  state.asleep = false;
  const Vec3 axis = Vec3(0.2, 1, 0.3).normalized(), centre = Vec3::Constant(cube.side / 2);
  for (Eigen::Index i = 0; i < body.nodes(); ++i)
    state.motion.v.segment<3>(3 * i) = spin * axis.cross(Vec3(state.motion.x.segment<3>(3 * i) - centre));
  const auto energy = [&] {
    return body.potential().elastic_energy(state.motion.x) +
           soft::kinetic_energy(body.node_mass(), state.motion.v);
  };
  const double start = energy(), turning = angular_momentum(body, state, centre).norm();
  coupled::Island island;
  island.soft.push_back({0, &body, &state});
  coupled::IslandStepper stepper;
  Spun out;
  for (int tick = 0; tick < ticks; ++tick) {
    const coupled::IslandReport report = stepper.step(island, h, Vec3::Zero());
    out.highest = std::max(out.highest, energy() / start);
    out.converged += report.converged;
    if (report.converged) out.worst_converged = std::max(out.worst_converged, report.residual);
  }
  out.energy = energy() / start;
  out.momentum = angular_momentum(body, state, centre).norm() / turning;
  return out;
}

// The energy of a soft body that turns swings by a thousandth in a third of a second: no gain, and no reason
// to take a tick again by another method, which each time took a hundredth.
TEST(Spin, MethodsThatKeepEnergyKeepItInTheAir) {
  for (const double spin : {6.0, 10.0}) {
    const Spun spun = spin_cube({0.1, 5e3, "tr_bdf2"}, spin, 600);
    EXPECT_GT(spun.energy, 0.95) << spin;
    EXPECT_GT(spun.momentum, 0.975) << spin;
    EXPECT_LT(spun.highest, 1.001) << spin;
  }
}

// E goes with the square of the size, so that waves cross each cube in the same time and all else is alike.
Cube of_size(double side) {
  return {side, 5e4 * std::pow(side / 0.1, 2), "tr_bdf2"};
}

TEST(Spin, SmallBodiesAreSolvedAsWellAsLargeOnes) {
  const Spun large = spin_cube(of_size(0.1), 6, 300), small = spin_cube(of_size(0.004), 6, 300);
  EXPECT_LT(1 - small.energy, 1.5 * (1 - large.energy));
  EXPECT_LT(1 - small.momentum, 1.5 * (1 - large.momentum));
}

// One Newton iteration of few conjugate gradients leaves half of the forces: that is not solved, however
// short a way the nodes of a small body go for it.
TEST(Spin, NoSolveThatLeavesHalfOfTheForcesHasConverged) {
  Cube cube = of_size(0.004);
  cube.youngs_modulus *= 100;
  cube.newton_iterations = 1;
  cube.solver_iterations = 4;
  const Spun spun = spin_cube(cube, 20, 120);
  EXPECT_LT(spun.worst_converged, 0.3) << spun.converged;
}

}  // namespace
}  // namespace prosector::test
