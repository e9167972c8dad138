#pragma once
// Solves islands with tissue or hands, and stores the results in the state.

#include <span>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Solves the islands, sets of connected bodies that contain tissue or hands, for a time step of h s. Stores
/// the velocities of their rigid bodies and the states and contact memories of their soft bodies, and appends
/// an entry for each soft body to the report.
void solve_islands(std::vector<coupled::Island>& islands, coupled::IslandStepper& stepper, Bodies& bodies,
                   const contact::SoftContacts& touching, double h, StepReport& report);

/// Changes the velocities of rigid bodies that collided in these islands (sets of bodies solved together) so
/// that they rebound with their restitution. Must be called after poses were integrated over h s.
void apply_restitution(std::vector<coupled::Island>& islands, rigid::RigidWorld& world, double h);

}  // namespace prosector
