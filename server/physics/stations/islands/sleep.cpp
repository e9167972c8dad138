#include "server/physics/stations/islands/sleep.h"

#include <algorithm>
#include <optional>
#include <span>

#include "server/physics/mechanics/coupled/recovery.h"
#include "server/physics/mechanics/coupled/vibration.h"
#include "server/physics/mechanics/soft/elements/relaxation.h"
#include "server/physics/stations/islands/recover_tangled.h"

namespace prosector {
namespace {

constexpr double quiet_rigid_speed = 5e-3;  // m/s
constexpr double quiet_rigid_spin = 5e-2;   // rad/s

bool touches(const coupled::Island& island, std::size_t soft_index) {
  const auto is_of_body = [&](const contact::ContactSide& side) {
    return side.kind == contact::ContactSide::Kind::soft && side.body == soft_index;
  };
  return std::any_of(island.contacts.begin(), island.contacts.end(),
                     [&](const contact::Contact& c) { return is_of_body(c.a) || is_of_body(c.b); });
}

/// Returns whether no hand and nothing kinematic touches the island.
bool is_left_alone(const coupled::Island& island, std::span<const hands::Hand> hands) {
  return !island.driven &&
         std::none_of(island.rigid.begin(), island.rigid.end(), [&](const coupled::RigidMember& r) {
           return hands::hand_at(hands, r.slot) != nullptr;
         });
}

/// Watches a rigid body that may linger within `within` (m), and damps it after it has lingered for long.
coupled::VibrationState calm(std::size_t slot, double within, rigid::RigidWorld& world,
                             coupled::Lingerers& lingerers) {
  const rigid::RigidMotion motion = world.motion(slot);
  const coupled::VibrationState unrest =
      lingerers.linger({static_cast<BodyId>(slot), coupled::points_of(motion.pose), within});
  if (unrest == coupled::VibrationState::calmed)
    world.set_velocity(slot, coupled::calming * motion.linear_velocity,
                       coupled::calming * motion.angular_velocity);
  return unrest;
}

/// Returns whether the body rests: it has been quiet, or has vibrated in place for so long that it must rest.
bool rests(coupled::SoftMember& s, BodyId id, std::optional<double> may_linger_within,
           coupled::Lingerers& lingerers) {
  coupled::count_quiet_ticks(s);
  if (!soft::has_relaxed(s.body->desc().material, s.state->history)) {  // the tissue still creeps
    s.state->quiet_ticks = 0;
    return false;
  }
  coupled::VibrationState unrest = coupled::VibrationState::moving;
  if (may_linger_within) unrest = lingerers.linger({id, s.state->motion.x, *may_linger_within});
  if (unrest == coupled::VibrationState::calmed) {
    s.state->motion.v *= coupled::calming;
    s.state->motion.has_history = false;
  }
  return s.state->quiet_ticks == coupled::quiet_ticks_to_sleep || unrest == coupled::VibrationState::over;
}

/// Returns whether a rigid body in contact with tissue rests: it is quiet, or has rocked in place for long.
bool rests(const coupled::RigidMember& r, bool may_linger, rigid::RigidWorld& world,
           coupled::Lingerers& lingerers) {
  const rigid::RigidMotion motion = world.motion(r.slot);
  const bool quiet =
      motion.linear_velocity.norm() < quiet_rigid_speed && motion.angular_velocity.norm() < quiet_rigid_spin;
  return (may_linger &&
          calm(r.slot, coupled::rigid_lingering_bound, world, lingerers) == coupled::VibrationState::over) ||
         quiet;
}

/// Damps rigid bodies outside these islands, and lets Bullet put those to sleep that rock in place. Triangle
/// meshes never come to rest otherwise.
void calm_rigid_bodies(rigid::RigidWorld& world, const std::vector<coupled::Island>& islands,
                       coupled::Lingerers& lingerers) {
  std::vector<char> elsewhere(world.slots());
  for (const coupled::Island& island : islands)
    for (const coupled::RigidMember& r : island.rigid) elsewhere[r.slot] = 1;
  for (std::size_t slot = 0; slot < world.slots(); ++slot) {
    if (elsewhere[slot] || !world.used(slot) || !world.dynamic(slot) || world.motion(slot).asleep) continue;
    if (calm(slot, coupled::lone_lingering_bound, world, lingerers) == coupled::VibrationState::over)
      world.sleep(slot, rigid::RigidWorld::Sleep::with_neighbours);
  }
}

}  // namespace

void update_sleep(State& state, std::vector<coupled::Island>& islands, bool driven) {
  Bodies& bodies = state.bodies;
  state.lingerers.begin_tick(state.time.tick);
  for (coupled::Island& island : islands) {
    const bool alone = is_left_alone(island, state.hands), tissue = !island.soft.empty();
    bool quiet = alone;
    for (coupled::SoftMember& s : island.soft) {
      const auto within = alone ? coupled::lingering_bound(*s.body, touches(island, s.index)) : std::nullopt;
      quiet &= rests(s, bodies.soft_id(s.index), within, state.lingerers) && coupled::may_sleep(s) &&
               !is_being_led(state.entangled, s.index);
    }
    for (const coupled::RigidMember& r : island.rigid)
      quiet &= rests(r, alone && tissue, bodies.rigid, state.lingerers);
    if (!tissue) continue;  // hands and held bodies only: Bullet puts the others to sleep
    for (const coupled::RigidMember& r : island.rigid)
      quiet ? bodies.rigid.sleep(r.slot) : bodies.rigid.stay_awake(r.slot);
    if (!quiet) continue;
    for (const coupled::SoftMember& s : island.soft) {
      bodies.soft[s.index].freeze();
      bodies.soft[s.index].stored.reset();
    }
  }
  if (!driven) calm_rigid_bodies(bodies.rigid, islands, state.lingerers);
  state.lingerers.end_tick();
  for (const coupled::Island& island : islands)
    for (const coupled::SoftMember& s : island.soft) bodies.soft[s.index].place_surface();
}

}  // namespace prosector
