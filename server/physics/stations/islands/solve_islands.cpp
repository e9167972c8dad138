#include "server/physics/stations/islands/solve_islands.h"

#include <fmt/format.h>

#include "server/physics/mechanics/coupled/restitution.h"

namespace prosector {
namespace {

void take_velocities(const coupled::Island& island, rigid::RigidWorld& world, double h) {
  for (const coupled::RigidMember& r : island.rigid)
    world.set_velocity(r.slot, r.twist.head<3>() / h, r.twist.tail<3>() / h);
}

BodyReport row_of(const coupled::SoftMember& s, const coupled::IslandReport& solved, const Bodies& bodies,
                  const contact::SoftContacts& touching, double h) {
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

void solve_islands(std::vector<coupled::Island>& islands, coupled::IslandStepper& stepper, Bodies& bodies,
                   const contact::SoftContacts& touching, double h, StepReport& report) {
  for (coupled::Island& island : islands) {
    const coupled::IslandReport solved = stepper.step(island, h, bodies.model.scene.gravity);
    if (solved.finite) take_velocities(island, bodies.rigid, h);
    for (const coupled::SoftMember& s : island.soft) {
      contact::keep(island.contacts, s.index, bodies.soft[s.index].memories);
      report.bodies.push_back(row_of(s, solved, bodies, touching, h));
      if (!solved.finite) stop(*s.state);
    }
    if (!island.soft.empty() && !island.rigid.empty()) ++report.mixed_islands;
  }
}

void apply_restitution(std::vector<coupled::Island>& islands, rigid::RigidWorld& world, double h) {
  for (coupled::Island& island : islands)
    if (coupled::bounce(island, h)) take_velocities(island, world, h);
}

}  // namespace prosector
