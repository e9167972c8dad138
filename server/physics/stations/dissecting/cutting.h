#pragma once
// Cutting of tissue by blades, and undo of cuts.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Cuts the soft bodies that blades swept through in this tick. `grips`: of this tick.
void cut_soft_bodies(State& state, std::span<const BladeGrip> grips, StepReport& report);

/// Undoes the participant's last cut in force. Returns the reason if that is impossible; nothing has changed
/// then.
Refusal undo_last_cut(State& state, ParticipantId participant, StepReport& report);

/// Prepares each mesh for its first cut when the scene is compiled, so that no tick has to do it.
void make_organs_ready(State& state);

/// Returns by node of a sheet whether an attachment holds it; empty: the body was no sheet.
std::vector<std::uint8_t> held_nodes_of(const State& state, std::size_t body);

}  // namespace prosector
