#include "server/physics/stations/parts/lost_bodies.h"

#include "common/room.h"
#include "server/physics/stations/hands/hands.h"
#include "server/physics/stations/parts/part_rules.h"

namespace prosector {
namespace {

constexpr double far_outside = 10;        // m beyond the room's sides: out of reach for all hands
constexpr double farthest_share = 0.9;    // of the largest coordinate of a pose
constexpr std::uint8_t most_returns = 3;  // returns are counted as first, second, or later

bool is_sound(const rigid::RigidMotion& motion) {
  return is_finite(motion.pose) && motion.linear_velocity.allFinite() && motion.angular_velocity.allFinite();
}

/// Returns the box outside of which bodies are lost. Upwards it ends only at the limit of poses, since bodies
/// fall down again.
collision::Aabb within_reach(const Bodies& bodies) {
  const Vec3 farthest = Vec3::Constant(farthest_share * max_coordinate);
  if (!bodies.model.scene.room) return {-farthest, farthest};
  const RoomShape room;
  const Vec3 half(room.width / 2 + far_outside, far_outside, room.depth / 2 + far_outside);
  return {-half, Vec3(half.x(), farthest.y(), half.z())};
}

/// Moves a body back to its start. A body that gets lost from its start again is put to sleep there, since
/// nothing supports it.
void bring_back(State& state, BodyId body, StepReport& report) {
  Bodies& bodies = state.bodies;
  std::uint8_t& times = bodies.lost[body];
  if (times < most_returns) ++times;
  let_go_of(state, body, "it left the room", report);
  put_at_start(bodies, body);
  const bool again = times > 1;
  if (bodies.is_soft(body))
    bodies.soft[bodies.soft_index(body)].state.asleep = again;
  else if (again)
    bodies.rigid.sleep(body);
  if (times == most_returns) return;
  BodyReport& row = report.bodies.emplace_back();
  row.body = bodies.name_of(body);
  row.reset = true;
  row.note = again ? "the body left the room again after it was moved back to its initial position: it rests "
                     "there until something moves it"
                   : "the body left the room: moved back to its initial position";
}

}  // namespace

void recover_hands(State& state, std::span<const rigid::RigidMotion> last_good, StepReport& report) {
  for (const hands::Hand& hand : state.hands) {
    const rigid::RigidMotion motion = state.bodies.rigid.motion(hand.slot);
    if (is_sound(motion) && motion.pose.p.cwiseAbs().maxCoeff() < max_coordinate) continue;
    rigid::RigidMotion back = last_good[hand.slot];
    back.linear_velocity = back.angular_velocity = Vec3::Zero();
    state.bodies.rigid.set_motion(hand.slot, back);
    BodyReport& row = report.bodies.emplace_back();
    row.body = "hand";
    row.reset = true;
    row.note =
        "the hand's position was not finite or outside the room: it was stopped at its last valid state";
  }
}

void return_lost_bodies(State& state, std::span<const coupled::Island> islands, StepReport& report) {
  Bodies& bodies = state.bodies;
  const collision::Aabb reach = within_reach(bodies);
  for (std::size_t slot = 0; slot < bodies.model.rigid.size(); ++slot) {
    if (!bodies.rigid.dynamic(slot)) continue;
    const rigid::RigidMotion motion = bodies.rigid.motion(slot);
    if (!is_sound(motion) || reach.squared_distance(motion.pose.p) > 0)
      bring_back(state, static_cast<BodyId>(slot), report);
  }
  for (const coupled::Island& island : islands)
    for (const coupled::SoftMember& s : island.soft)
      if (!reach.overlaps(
              {bodies.soft[s.index].surface.vertices().lo(), bodies.soft[s.index].surface.vertices().hi()}))
        bring_back(state, bodies.soft_id(s.index), report);
}

}  // namespace prosector
