#pragma once
// Bones that broke in a tick.

#include <span>

#include "server/physics/contact/colliders.h"
#include "server/physics/island.h"
#include "server/physics/state.h"
#include "server/physics/step_report.h"

namespace prosector {

/// Breaks what more force went through in the last h s than it bears. `islands` and `colliders`: of those h
/// s.
void break_bones(State& state, std::span<const Island> islands, std::span<const Collider> colliders, double h,
                 StepReport& report);

}  // namespace prosector
