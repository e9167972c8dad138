#pragma once
// Soft bodies that no force leads back are unfolded, and put out of what they are in.

#include <vector>

#include "server/physics/contact/soft_contacts.h"
#include "server/physics/island.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Returns whether the soft body is being led out of another; false once that has been given up.
bool is_being_led(const Entanglements& entangled, std::size_t body);

/// Unfolds, every few ticks, what of these islands has stayed tangled, and puts apart what has stayed in each
/// other; says so. `touching` and h (s): of the last solution.
void unfold_tangles(State& state, std::vector<Island>& islands, const SoftContacts& touching, double h,
                    StepReport& report);

}  // namespace prosector
