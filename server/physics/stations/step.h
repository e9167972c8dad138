#pragma once
// One tick of the simulation.

#include <memory>
#include <vector>

#include "server/physics/base/step_report.h"
#include "server/physics/mechanics/coupled/step_island.h"
#include "server/physics/stations/dissecting/blade_grip.h"
#include "server/physics/stations/hands/pads.h"
#include "server/physics/stations/touching/soft_contact_finder.h"
#include "server/physics/world/state.h"
#include "server/physics/world/tick_input.h"
#include "server/physics/world/tick_output.h"

namespace prosector {

/// Buffers of a tick, and data for queries about the last tick. They don't affect the results of the next
/// tick.
struct StepBuffers {
  explicit StepBuffers(const State& state) : contacts(state.bodies.soft.size()), h(state.bodies.model.h) {}

  Colliders colliders;
  SoftContactFinder contacts;
  std::vector<organs::BladeGrip> grips;
  std::vector<rigid::RigidMotion> last_good;  // by slot, before the last solve
  std::vector<coupled::Island> islands;
  std::vector<Pad> pads;  // in the order of the islands
  coupled::IslandStepper stepper;
  double h;                                 // s: duration of the tick's last part
  std::vector<Exchange> earlier_exchanges;  // of the tick's earlier parts
  std::vector<HandState> hand_states;
};

/// Advances the simulation's state by one tick, consuming `input`, and fills the report. `buffers` are reused
/// from tick to tick.
void step(State& state, StepBuffers& buffers, const TickInput& input, StepReport& report);

/// Returns the exchanges of the last tick: impulse, depth and contact point of each pair of bodies that
/// touched.
std::vector<Exchange> exchanges(const State& state, const StepBuffers& buffers);

/// Clears the buffers' data about the last tick after the state was replaced, such as by a restored
/// checkpoint. Hands have no contacts until the next tick.
void clear_last_tick(const State& state, StepBuffers& buffers);

}  // namespace prosector
