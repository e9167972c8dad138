#pragma once
// Unfolds soft bodies that no force restores, and separates bodies that stay in each other.

#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/contact/soft_contacts.h"
#include "server/physics/mechanics/coupled/island.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Returns whether the soft body is being led out of another; false after that has been given up.
bool is_being_led(const Entanglements& entangled, std::size_t body);

/// Unfolds, every few ticks, bodies of these islands that have stayed tangled, and separates bodies that have
/// stayed in each other; reports both. `touching` and h (s): of the last solve.
void recover_tangled_bodies(State& state, std::vector<Island>& islands, const SoftContacts& touching,
                            double h, StepReport& report);

}  // namespace prosector
