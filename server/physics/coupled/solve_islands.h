#pragma once
// Islands with tissue or hands are solved, and what comes out of it is taken into the state.

#include <span>
#include <vector>

#include "server/physics/contact/soft_contacts.h"
#include "server/physics/coupled/step_island.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Solves the islands for h s. Their rigid bodies get velocities, their soft ones states and contact
/// memories, and the report a row for each soft one.
void solve_islands(std::vector<Island>& islands, IslandStepper& stepper, Bodies& bodies,
                   const SoftContacts& touching, double h, StepReport& report);

/// Lets rigid bodies that pressed each other bounce, after their poses were integrated.
void bounce_rigid(std::vector<Island>& islands, RigidWorld& world, double h);

}  // namespace prosector
