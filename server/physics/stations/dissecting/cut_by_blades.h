#pragma once
// Cutting of tissue by blades, and undo of cuts.

#include <span>

#include "server/physics/base/step_report.h"
#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/world/state.h"

namespace prosector {

/// Cuts the soft bodies through which blades swept in this tick, and reports the changes. `grips` are this
/// tick's ties between tissue and the blades' edges.
void cut_soft_bodies(State& state, std::span<const organs::BladeGrip> grips, StepReport& report);

/// Undoes the participant's last stroke (continuous cut) that was not undone yet. If that is impossible,
/// returns the reason and changes nothing.
Refusal undo_last_cut(State& state, ParticipantId participant, StepReport& report);

/// Prepares the mesh of each soft body that a blade could cut for its first cut. This is done when the scene
/// is compiled, so that no tick has to do it.
void make_organs_ready(State& state);

/// Returns, for each node of a sheet, whether an attachment holds it (1) or not (0). For a body that was cut,
/// the nodes are those of the uncut sheet. Empty if the body is not a sheet.
std::vector<std::uint8_t> held_nodes_of(const State& state, std::size_t body);

}  // namespace prosector
