#include "server/physics/coupled/sleep.h"

#include <algorithm>
#include <span>

#include "server/physics/coupled/lingering.h"
#include "server/physics/coupled/recovery.h"
#include "server/physics/coupled/unfold_tangles.h"
#include "server/physics/soft/elements/relaxation.h"

namespace prosector {
namespace {

constexpr double quiet_rigid_speed = 5e-3;  // m/s
constexpr double quiet_rigid_spin = 5e-2;   // rad/s

bool touches(const Island& island, std::size_t soft_index) {
  const auto is_of_body = [&](const ContactSide& side) {
    return side.kind == ContactSide::Kind::soft && side.body == soft_index;
  };
  return std::any_of(island.contacts.begin(), island.contacts.end(),
                     [&](const Contact& c) { return is_of_body(c.a) || is_of_body(c.b); });
}

/// Returns whether nobody moves what is in the island: no hand and nothing kinematic.
bool is_left_alone(const Island& island, std::span<const Hand> hands) {
  return !island.driven && std::none_of(island.rigid.begin(), island.rigid.end(), [&](const RigidMember& r) {
    return hand_at(hands, r.slot) != nullptr;
  });
}

/// Returns whether the body rests: it has been quiet, or has shivered in its place for so long that it shall.
bool rests(SoftMember& s, BodyId id, bool may_linger, Lingerers& lingerers) {
  count_quiet_ticks(s);
  if (!has_relaxed(s.body->desc(), s.state->history)) {  // it creeps
    s.state->quiet_ticks = 0;
    return false;
  }
  Unrest unrest = Unrest::moving;
  if (may_linger) unrest = lingerers.linger({id, s.state->motion.x, lingering_bound(*s.body)});
  if (unrest == Unrest::calmed) {
    s.state->motion.v *= calming;
    s.state->motion.has_history = false;
  }
  return s.state->quiet_ticks == quiet_ticks_to_sleep || unrest == Unrest::over;
}

/// Returns whether a rigid body that touches tissue rests: it is quiet, or has rocked in its place for long.
bool rests(const RigidMember& r, bool may_linger, RigidWorld& world, Lingerers& lingerers) {
  const RigidMotion motion = world.motion(r.slot);
  Unrest unrest = Unrest::moving;
  if (may_linger)
    unrest = lingerers.linger({static_cast<BodyId>(r.slot), points_of(motion.pose), rigid_lingering_bound});
  if (unrest == Unrest::calmed)
    world.set_velocity(r.slot, calming * motion.linear_velocity, calming * motion.angular_velocity);
  const bool quiet =
      motion.linear_velocity.norm() < quiet_rigid_speed && motion.angular_velocity.norm() < quiet_rigid_spin;
  return quiet || unrest == Unrest::over;
}

}  // namespace

void fall_asleep(State& state, std::vector<Island>& islands) {
  Bodies& bodies = state.bodies;
  state.lingerers.begin_tick(state.time.tick);
  for (Island& island : islands) {
    const bool alone = is_left_alone(island, state.hands), tissue = !island.soft.empty();
    bool quiet = alone;
    for (SoftMember& s : island.soft) {
      const bool may_linger = alone && touches(island, s.index);
      quiet &= rests(s, bodies.soft_id(s.index), may_linger, state.lingerers) && may_sleep(s) &&
               !is_being_led(state.entangled, s.index);
    }
    for (const RigidMember& r : island.rigid)
      quiet &= rests(r, alone && tissue, bodies.rigid, state.lingerers);
    if (!tissue) continue;  // hands and what they hold: Bullet puts the rest to sleep
    for (const RigidMember& r : island.rigid)
      quiet ? bodies.rigid.sleep(r.slot) : bodies.rigid.stay_awake(r.slot);
    if (!quiet) continue;
    for (const SoftMember& s : island.soft) {
      bodies.soft[s.index].freeze();
      bodies.soft[s.index].stored.reset();
    }
  }
  state.lingerers.end_tick();
  for (const Island& island : islands)
    for (const SoftMember& s : island.soft) bodies.soft[s.index].place_surface();
}

}  // namespace prosector
