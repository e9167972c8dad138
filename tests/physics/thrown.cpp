#include "tests/physics/thrown.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "server/physics/mechanics/collision/surface/triangle_surface.h"
#include "server/physics/mechanics/soft/mechanical_energy.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/patched_state.h"
#include "tests/physics/scenes.h"
#include "tests/play/judge.h"

namespace prosector::test {
namespace {

constexpr double fall = 1;  // m/s², of both alike: a body that moves has a velocity that can be found

collision::TriangleSurface surface_of(const Simulation& simulation, BodyId body) {
  const Anatomy& anatomy = simulation.soft(body).anatomy();
  TriangleMesh mesh = anatomy.surface;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions[i] = anatomy.embedding.apply(i, simulation.soft_state(body).motion.x.data());
  return collision::TriangleSurface(mesh);
}

}  // namespace

SceneDesc two_livers(const ThrownRung& left, const ThrownRung& right, double cell) {
  SceneDesc scene;
  scene.gravity = {0, -fall, 0};
  for (const ThrownRung* rung : {&left, &right}) {
    SoftDesc& soft = scene.soft.emplace_back();
    soft.name = scene.soft.size() == 1 ? "left" : "right";
    soft.geometry.shape = "liver";
    soft.geometry.size = {0.2, 0.1, 0.15};
    soft.configuration.model = rung->model;
    soft.configuration.integrator = rung->integrator;
    soft.geometry.cell = cell;
    soft.geometry.surface_cell = cell / 2;
    soft.material.damping_mass = 0;
  }
  scene.soft[0].pose.p = {-0.13, 0, 0};
  scene.soft[1].pose.p = {0.13, 0.02, 0.01};  // off its middle
  return scene;
}

void throw_body(Simulation& simulation, BodyId body, const Vec3& velocity) {
  const VecX now = simulation.soft_state(body).motion.v;
  if (now.isZero(0)) throw std::logic_error("throw_body: the body doesn't move");
  simulation.restore(with_values(simulation.checkpoint(), now, velocity.replicate(now.size() / 3, 1)));
}

Vec3 momentum(const Simulation& simulation, BodyId body) {
  const VecX& mass = simulation.soft(body).node_mass();
  return simulation.soft_state(body).motion.v.reshaped(3, mass.size()) * mass;
}

Vec3 centre(const Simulation& simulation, BodyId body) {
  const VecX& x = simulation.soft_state(body).motion.x;
  return x.reshaped(3, x.size() / 3).rowwise().mean();
}

double distortion(const Simulation& simulation, BodyId body) {
  const collision::TriangleSurface now = surface_of(simulation, body);
  const auto& rest = simulation.soft(body).anatomy().surface.positions;
  double worst = 0;
  for (std::size_t from : {std::size_t{0}, rest.size() / 3, 2 * rest.size() / 3})
    for (std::size_t i = 0; i < rest.size(); ++i)
      worst = std::max(worst, std::abs((now.positions()[i] - now.positions()[from]).norm() -
                                       (rest[i] - rest[from]).norm()));
  return worst;
}

Thrown throw_at_each_other(Simulation& simulation, int ticks,
                           const std::function<const StepReport&()>& step) {
  step();
  const Vec3 throws(thrown_speed, 0, 0);
  throw_body(simulation, 0, throws);
  throw_body(simulation, 1, -throws);
  const double mass = simulation.soft(0).total_mass() + simulation.soft(1).total_mass();
  const double h = 1 / simulation.scene().tick_rate;
  const Vec3 left = momentum(simulation, 0), right = momentum(simulation, 1);
  const double start =
      soft::kinetic_energy(simulation.soft(0).node_mass(), simulation.soft_state(0).motion.v) +
      soft::kinetic_energy(simulation.soft(1).node_mass(), simulation.soft_state(1).motion.v);
  Thrown out;
  double lost = 0, highest = 0, first = 0;
  for (int tick = 1; tick <= ticks; ++tick) {
    const StepReport& report = step();
    if (tick == 1) first = energy(report);
    highest = std::max(highest, energy(report) - first);
    out.reported += std::any_of(report.bodies.begin(), report.bodies.end(),
                                [](const BodyReport& b) { return b.reset || !b.converged; });
    for (const BodyId body : {0u, 1u})
      out.finite = out.finite && simulation.soft_state(body).motion.x.allFinite();
    if (!out.finite) return out;
    const Vec3 taken = momentum(simulation, 0), kept = momentum(simulation, 1);
    const Vec3 fallen = tick * h * simulation.scene().gravity;  // m/s
    out.exchanged = std::max(out.exchanged, (taken - left - simulation.soft(0).total_mass() * fallen).norm());
    lost = std::max(lost, (taken + kept - left - right - mass * fallen).norm());
    out.deepest = std::max(out.deepest, overlap(simulation, 0, 1));
  }
  out.momentum_lost = lost / out.exchanged;
  out.energy_gained = highest / start;
  out.overlap_after = overlap(simulation, 0, 1);
  out.parting = (momentum(simulation, 1) / simulation.soft(1).total_mass() -
                 momentum(simulation, 0) / simulation.soft(0).total_mass())
                    .dot((centre(simulation, 1) - centre(simulation, 0)).normalized());
  out.distortion_after = std::max(distortion(simulation, 0), distortion(simulation, 1));
  return out;
}

}  // namespace prosector::test
