#include "server/physics/coupled/sleep.h"

#include <span>

#include "server/physics/coupled/recovery.h"
#include "server/physics/coupled/unfold_tangles.h"
#include "server/physics/soft/relaxation.h"

namespace prosector {
namespace {

constexpr double quiet_rigid_speed = 5e-3;  // m/s
constexpr double quiet_rigid_spin = 5e-2;   // rad/s

bool is_quiet(const SoftMember& s, const Entanglements& entangled) {
  return s.state->quiet_ticks == quiet_ticks_to_sleep && may_sleep(s) && !is_being_led(entangled, s.index);
}

bool is_quiet(const RigidMember& r, const RigidWorld& world, std::span<const Hand> hands) {
  const RigidMotion motion = world.motion(r.slot);
  return !hand_at(hands, r.slot) && motion.linear_velocity.norm() < quiet_rigid_speed &&
         motion.angular_velocity.norm() < quiet_rigid_spin;
}

}  // namespace

void fall_asleep(State& state, std::vector<Island>& islands) {
  Bodies& bodies = state.bodies;
  for (Island& island : islands) {
    bool quiet = !island.driven;
    for (SoftMember& s : island.soft) {
      count_quiet_ticks(s);
      if (!has_relaxed(s.body->desc(), s.state->history)) s.state->quiet_ticks = 0;  // it creeps
      quiet = quiet && is_quiet(s, state.entangled);
    }
    for (const RigidMember& r : island.rigid) quiet = quiet && is_quiet(r, bodies.rigid, state.hands);
    if (island.soft.empty()) continue;  // hands and what they hold: Bullet puts the rest to sleep
    for (const RigidMember& r : island.rigid)
      quiet ? bodies.rigid.sleep(r.slot) : bodies.rigid.stay_awake(r.slot);
    if (!quiet) continue;
    for (const SoftMember& s : island.soft) {
      bodies.soft[s.index].freeze();
      bodies.soft[s.index].stored.reset();
    }
  }
  for (const Island& island : islands)
    for (const SoftMember& s : island.soft) bodies.soft[s.index].place_surface();
}

}  // namespace prosector
