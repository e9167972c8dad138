#pragma once
// Unfolds soft bodies that no force restores, and separates bodies that stay in each other.

#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns whether the soft body overlaps another one and contact forces are leading it out. Returns false
/// once that has lasted so long that it counts as failed.
bool is_being_led(const Entanglements& entangled, std::size_t body);

/// Resets to their rest shape the bodies of these islands (sets of bodies solved together) that stayed
/// tangled, separates bodies that stayed overlapping, and reports both. Does so only every few ticks.
/// `touching` are the contacts of the last solve, `h` (s) is its time step.
void recover_tangled_bodies(State& state, std::vector<coupled::Island>& islands,
                            const contact::SoftContacts& touching, double h, StepReport& report);

}  // namespace prosector
