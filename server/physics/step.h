#pragma once
// One tick.

#include <memory>
#include <vector>

#include "server/physics/contact/soft_contact_finder.h"
#include "server/physics/coupled/step_island.h"
#include "server/physics/hands/pads.h"
#include "server/physics/organs/blade_grip.h"
#include "server/physics/simulation.h"
#include "server/physics/state.h"

namespace prosector {

/// What ticks work in, and what the last one may still be asked about. Nothing of it decides the next tick.
struct StepBuffers {
  explicit StepBuffers(const State& state) : contacts(state.bodies.soft.size()), h(state.bodies.model.h) {}

  Colliders colliders;
  SoftContactFinder contacts;
  std::vector<BladeGrip> grips;
  std::vector<RigidMotion> last_good;  // by slot, before the last solution
  std::vector<Island> islands;
  std::vector<Pad> pads;  // in the islands' order
  IslandStepper stepper;
  double h;                                 // s: of the tick's last part
  std::vector<Exchange> earlier_exchanges;  // of the parts before that
  std::vector<HandState> hand_states;
};

/// Advances the state one tick. Fills the report.
void step(State& state, StepBuffers& buffers, const TickInput& input, StepReport& report);

/// Returns what bodies did to each other in the last tick.
std::vector<Exchange> exchanges(const State& state, const StepBuffers& buffers);

/// Forgets the last tick, to which the state doesn't belong any more: hands touch nothing until the next.
void forget_last_tick(const State& state, StepBuffers& buffers);

}  // namespace prosector
