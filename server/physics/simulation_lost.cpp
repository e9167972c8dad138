// What is lost: a hand that went where no pose is, and bodies that left the room.

#include "common/room.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double far_outside = 10;        // m beyond the room's sides: nobody reaches it
constexpr double farthest_share = 0.9;    // of the farthest place that a pose may have
constexpr std::uint8_t most_returns = 3;  // that are told apart: the first, the second, later ones

bool is_sound(const RigidMotion& motion) {
  return is_finite(motion.pose) && motion.linear_velocity.allFinite() && motion.angular_velocity.allFinite();
}

}  // namespace

void Simulation::Impl::recover_hands() {
  for (const Hand& hand : hands) {
    const RigidMotion motion = world.motion(hand.slot);
    if (is_sound(motion) && motion.pose.p.cwiseAbs().maxCoeff() < max_coordinate) continue;
    RigidMotion back = last_good[hand.slot];
    back.linear_velocity = back.angular_velocity = Vec3::Zero();
    world.set_motion(hand.slot, back);
    BodyReport& row = report.bodies.emplace_back();
    row.body = "hand";
    row.reset = true;
    row.note = "not finite or out of the room: stopped at its last good state";
  }
}

/// What flies up comes down again, so that way it ends only where poses do.
Aabb Simulation::Impl::within_reach() const {
  const Vec3 farthest = Vec3::Constant(farthest_share * max_coordinate);
  if (!model.scene.room) return {-farthest, farthest};
  const RoomShape room;
  const Vec3 half(room.width / 2 + far_outside, far_outside, room.depth / 2 + far_outside);
  return {-half, Vec3(half.x(), farthest.y(), half.z())};
}

void Simulation::Impl::bring_back_lost() {
  const Aabb reach = within_reach();
  for (std::size_t slot = 0; slot < model.rigid.size(); ++slot) {
    if (!world.dynamic(slot)) continue;
    const RigidMotion motion = world.motion(slot);
    if (!is_sound(motion) || reach.squared_distance(motion.pose.p) > 0) bring_back(static_cast<BodyId>(slot));
  }
  for (const Island& island : islands)
    for (const SoftMember& s : island.soft)
      if (!reach.overlaps({surfaces[s.index].lo(), surfaces[s.index].hi()})) bring_back(soft_id(s.index));
}

/// A body that gets lost from its very place is left to sleep there: nothing carries it.
void Simulation::Impl::bring_back(BodyId body) {
  std::uint8_t& times = lost[body];
  if (times < most_returns) ++times;
  let_go_of(body, "it left the room");
  put_at_start(body);
  const bool again = times > 1;
  if (is_soft(body))
    soft[soft_index(body)].asleep = again;
  else if (again)
    world.sleep(body);
  if (times == most_returns) return;
  BodyReport& row = report.bodies.emplace_back();
  row.body = name_of(body);
  row.reset = true;
  row.note = again ? "it left the room from its place, again: it rests there until something moves it"
                   : "it left the room: it is back at its place";
}

}  // namespace prosector
