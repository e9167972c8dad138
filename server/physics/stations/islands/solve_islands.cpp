#include "server/physics/stations/islands/solve_islands.h"

#include <fmt/format.h>

#include "server/physics/mechanics/coupled/restitution.h"

namespace prosector {
namespace {

void take_velocities(const Island& island, RigidWorld& world, double h) {
  for (const RigidMember& r : island.rigid)
    world.set_velocity(r.slot, r.twist.head<3>() / h, r.twist.tail<3>() / h);
}

BodyReport row_of(const SoftMember& s, const IslandReport& solved, const Bodies& bodies,
                  const SoftContacts& touching, double h) {
  BodyReport row;
  row.body = s.body->desc().name;
  row.newton_iterations = solved.newton_iterations;
  row.solver_iterations = solved.solver_iterations;
  row.residual = solved.residual;
  row.last_step = solved.last_step;
  row.converged = solved.converged && !s.degraded;
  row.substep = s.substeps > 0 ? h / s.substeps : 0;
  row.note = s.note;
  if (touching.passed_through[s.index] > 0) {
    row.converged = false;
    row.note = fmt::format("{} pairs of the body's own elements penetrate each other",
                           touching.passed_through[s.index]);
  }
  if (touching.parted[s.index]) {
    row.converged = false;
    row.note =
        fmt::format("overlaps {}: being separated", bodies.soft[*touching.parted[s.index]].desc().name);
  }
  row.reset = !solved.finite;
  if (row.reset)
    row.note =
        "the body's positions were not finite or outside the room: it was stopped at its last valid state";
  return row;
}

}  // namespace

void solve_islands(std::vector<Island>& islands, IslandStepper& stepper, Bodies& bodies,
                   const SoftContacts& touching, double h, StepReport& report) {
  for (Island& island : islands) {
    const IslandReport solved = stepper.step(island, h, bodies.model.scene.gravity);
    if (solved.finite) take_velocities(island, bodies.rigid, h);
    for (const SoftMember& s : island.soft) {
      keep(island.contacts, s.index, bodies.soft[s.index].memories);
      report.bodies.push_back(row_of(s, solved, bodies, touching, h));
      if (!solved.finite) stop(*s.state);
    }
    if (!island.soft.empty() && !island.rigid.empty()) ++report.mixed_islands;
  }
}

void apply_restitution(std::vector<Island>& islands, RigidWorld& world, double h) {
  for (Island& island : islands)
    if (bounce(island, h)) take_velocities(island, world, h);
}

}  // namespace prosector
