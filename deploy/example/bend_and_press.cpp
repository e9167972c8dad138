// A beam bends under its own weight; a ball presses an organ. SI units, y is up.

#include <common/error.h>
#include <server/physics/mechanics/soft/soft_body.h>
#include <server/physics/simulation.h>

#include <cstdio>

using namespace prosector;

int main() try {
  SceneDesc scene;
  SoftDesc beam;
  beam.name = "beam";
  beam.geometry.shape = "beam";
  beam.geometry.size = {0.40, 0.04, 0.04};
  beam.geometry.cell = 0.02;
  beam.configuration.element = "tet10";
  beam.configuration.solver = "multigrid";
  beam.material.youngs_modulus = 1e7;
  beam.material.density = 1000;
  beam.attach = {{.center = {-0.20, 0, 0}, .radius = 0.05, .stiffness = 1e12}};

  SoftDesc kidney;
  kidney.name = "kidney";
  kidney.geometry.shape = "kidney";
  kidney.geometry.size = {0.06, 0.11, 0.05};
  kidney.pose.p = {0, 0, 0.5};
  kidney.attach = {{.center = {0, -0.03, 0.5}, .radius = 0.05, .stiffness = 1e8}};

  RigidDesc ball;
  ball.name = "ball";
  ball.geometry.parts = {{.shape = "sphere", .size = {0.03, 0, 0}}};
  ball.fixed = true;  // it goes where it is driven
  ball.pose.p = {0, 0.08, 0.5};
  scene.soft = {beam, kidney};
  scene.rigid = {ball};

  Simulation simulation(scene, {.threads = 1});              // finds the equilibrium under gravity
  constexpr BodyId ball_id = 0, beam_id = 1, kidney_id = 2;  // rigid bodies first
  const VecX sag = simulation.soft_state(beam_id).motion.x - simulation.soft(beam_id).rest();
  std::printf("beam: %ld nodes, its free end sags by %.2f mm\n", static_cast<long>(sag.size() / 3),
              -1e3 * sag.minCoeff());

  for (int tick = 1; tick <= 60; ++tick) {
    ball.pose.p.y() = 0.08 - 0.03 * tick / 60;
    simulation.step({.kinematic_targets = {{ball_id, ball.pose}}});
  }
  for (const Exchange& pressed : simulation.exchanges())
    std::printf("ball: presses with %.3f N at %u contact points\n", pressed.normal_impulse * scene.tick_rate,
                pressed.points);
  std::printf("kidney: its surface moves by up to %.2f mm\n", 1e3 * simulation.max_displacement(kidney_id));
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
