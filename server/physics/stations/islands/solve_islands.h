#pragma once
// Solves islands with tissue or hands, and stores the results in the state.

#include <span>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Solves the islands for h s. Sets velocities of rigid bodies, states and contact memories of soft bodies,
/// and adds a report row for each soft body.
void solve_islands(std::vector<Island>& islands, IslandStepper& stepper, Bodies& bodies,
                   const SoftContacts& touching, double h, StepReport& report);

/// Applies restitution to rigid contacts after poses were integrated.
void apply_restitution(std::vector<Island>& islands, RigidWorld& world, double h);

}  // namespace prosector
