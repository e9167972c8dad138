#pragma once
// Results and statistics of a simulation step.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/ids.h"
#include "common/refusal.h"
#include "server/physics/base/topology.h"

namespace prosector {

/// Phases of a simulation step whose durations are measured, in the order in which Simulation::step runs
/// them.
enum class Phase : std::uint8_t { inputs, broad, narrow, islands, coupled, rigid, constraints, report };
inline constexpr std::array<const char*, step_phases> phase_names = {
    "inputs", "broad", "narrow", "islands", "coupled", "rigid", "constraints", "report"};

struct BodyReport {
  std::string body;
  int newton_iterations = 0;
  int solver_iterations = 0;
  double residual = 0;   // relative, of the last linear solve
  double last_step = 0;  // m: how far the last Newton step moved a node or body
  bool converged = true;
  double substep = 0;  // s: step length of bodies with several substeps per tick; 0: one step per tick
  bool reset = false;  // went non-finite: put back to its last good state; or unfolded
  std::string note;    // text for users
};

/// A hand that lost or released the body that it held, with the reason as text for users.
struct LetGo {
  ParticipantId participant = 0;
  std::size_t hand = right_hand;
  BodyId body = 0;
  std::string why;
};

/// A body that broke at a fracture plane, and the force through that plane.
struct Broken {
  BodyId body = 0;
  double force = 0;  // N
};

/// A button of a participant's control panel whose action failed, with the reason as text for that
/// participant.
struct PanelRefusal {
  ParticipantId participant = 0;
  std::string why;
};

struct StepReport {
  SimTime time;                               // of the state after the step
  std::array<double, step_phases> seconds{};  // wall time per phase; measured outside what decides anything
  double total_seconds = 0;
  std::uint32_t contacts = 0;
  std::uint32_t mixed_islands = 0;
  std::uint32_t awake_bodies = 0, asleep_bodies = 0;
  double kinetic_energy = 0, elastic_energy = 0, potential_energy = 0;  // J
  std::vector<Refusal> part_answers;                                    // to TickInput::parts, in order
  std::vector<Refusal> cut_answers;                                     // to TickInput::cuts, in order
  std::vector<TopologyChange> topology;  // in order; new pieces have the next body ids
  std::vector<LetGo> let_go;
  std::vector<Broken> broken;
  std::vector<HandRef> panel_carriers;       // hands that carry a panel, ascending
  std::vector<PanelRefusal> panel_refusals;  // in the order of the buttons' presses
  std::vector<BodyReport> bodies;  // soft bodies that were solved, and any body with something to report
};

}  // namespace prosector
