#include "server/physics/stations/step.h"

#include <utility>

#include "server/physics/base/phase_clock.h"
#include "server/physics/stations/cut_events.h"
#include "server/physics/stations/dissecting/cut_by_blades.h"
#include "server/physics/stations/dissecting/refining.h"
#include "server/physics/stations/hands/holding.h"
#include "server/physics/stations/hands/reaching.h"
#include "server/physics/stations/islands/island_builder.h"
#include "server/physics/stations/islands/recover_tangled.h"
#include "server/physics/stations/islands/sleep.h"
#include "server/physics/stations/islands/solve_islands.h"
#include "server/physics/stations/panels/panel_station.h"
#include "server/physics/stations/parts/breaking.h"
#include "server/physics/stations/parts/lost_bodies.h"
#include "server/physics/stations/report.h"
#include "server/physics/stations/take_inputs.h"
#include "server/physics/stations/tick_parts.h"

namespace prosector {
namespace {

std::vector<rigid::RigidMotion> motions(const rigid::RigidWorld& world) {
  std::vector<rigid::RigidMotion> out(world.slots());
  for (std::size_t slot = 0; slot < world.slots(); ++slot)
    if (world.used(slot)) out[slot] = world.motion(slot);
  return out;
}

/// Finds and solves contacts for a part of the tick, of duration StepBuffers::h.
void advance_part(State& s, StepBuffers& b, PhaseClock& clock, StepReport& report) {
  rigid::RigidWorld& world = s.bodies.rigid;
  world.detect(b.h);
  clock.end(Phase::broad);
  grip_blades(s, b.grips);
  refresh(b.colliders, s.bodies, s.hands, s.dissection.blades);
  const contact::SoftContacts& touching = b.contacts.find(s, b.colliders, b.h);  // wakes touched bodies
  clock.end(Phase::narrow);
  const std::vector<rigid::RigidContact> reached = reached_bodies(s.bodies, b.colliders, s.hands, b.h);
  const std::vector<rigid::MixedIsland>& mixed =
      find_islands(s.bodies, s.hands, reached, touching, b.grips, b.h);
  clock.end(Phase::rigid);  // includes the islands that Bullet solves inside find_islands()
  IslandBuilder(s.bodies, s.hands, reached, touching, b.colliders, b.grips, b.h)
      .build(mixed, b.islands, b.pads);
  clock.end(Phase::islands);
  b.last_good = motions(world);
  solve_islands(b.islands, b.stepper, s.bodies, touching, b.h, report);
  store_pads(world, b.islands, b.pads, s.hands);
  clock.end(Phase::coupled);
  world.integrate(b.h);
  apply_restitution(b.islands, world, b.h);
  clock.end(Phase::rigid);
}

/// Runs the tick in one part, or in several if something kinematic is fast.
void advance_in_parts(State& s, StepBuffers& b, PhaseClock& clock, StepReport& report) {
  b.earlier_exchanges.clear();
  TickParts parts(s, b.colliders);
  b.h = parts.h();
  for (int k = 0; k < parts.count(); ++k) {
    parts.aim(k);
    if (k > 0) {
      b.earlier_exchanges = exchanges(s, b);
      for (Exchange& e : b.earlier_exchanges) e.points = 0;
    }
    advance_part(s, b, clock, report);
  }
  parts.finish(report);
}

}  // namespace

void step(State& s, StepBuffers& b, const TickInput& input, StepReport& report) {
  PhaseClock clock(report);
  take_inputs(s, b.colliders, input, report);
  clock.end(Phase::inputs);
  advance_in_parts(s, b, clock, report);
  ++s.time.tick;
  recover_hands(s, b.last_good, report);
  recover_tangled_bodies(s, b.islands, b.contacts.found(), b.h, report);
  update_sleep(s, b.islands, !input.kinematic_targets.empty());
  return_lost_bodies(s, b.islands, report);
  update_holds(s, b.islands, b.h, report);
  break_bones(s, b.islands, b.colliders, b.h, report);
  if (s.panels) step_panels(s, describe_hands(s, b.islands, b.colliders, b.h), report);
  clock.end(Phase::constraints);
  describe(s, b.islands, report);
  b.hand_states = describe_hands(s, b.islands, b.colliders, b.h);
  clock.end(Phase::report);
  PlacesOfBodies pressed = pressed_places(s, b.islands, input.kinematic_targets);
  cut_soft_bodies(s, b.grips, report);  // from here on: the state that the next tick starts from
  if (apply_cut_events(s, input.cuts, report)) {
    b.islands.clear();
    b.hand_states = describe_hands(s, b.islands, b.colliders, b.h);
  }
  refine_touched(s, std::move(pressed));
  clock.end(Phase::constraints);
}

std::vector<Exchange> exchanges(const State& s, const StepBuffers& b) {
  return exchanges(b.earlier_exchanges, b.islands, s.bodies.model.rigid.size(), b.h);
}

void clear_last_tick(const State& s, StepBuffers& b) {
  b.earlier_exchanges.clear();
  b.islands.clear();
  b.hand_states = describe_hands(s, b.islands, b.colliders, b.h);
}

}  // namespace prosector
