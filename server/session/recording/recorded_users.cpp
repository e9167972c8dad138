#include "server/session/recording/recorded_users.h"

namespace prosector {
namespace {

constexpr double least_distance = 0.01;  // m from the eyes to their target

/// Returns the pose of an upright head with its eyes at `from`, looking at `target`.
Pose look_at(const Vec3& from, const Vec3& target) {
  const Vec3 back = from - target;
  if (back.norm() < least_distance) return {from, Quat::Identity()};
  const Vec3 z = back.normalized();
  const Vec3 across = Vec3::UnitY().cross(z);
  const Vec3 x = across.norm() > 1e-6 ? Vec3(across.normalized()) : Vec3(Vec3::UnitX());
  Mat3 axes;
  axes << x, z.cross(x), z;
  return {from, Quat(axes)};
}

}  // namespace

std::vector<UserState> recorded_users(const Simulation& simulation, const Roster& people,
                                      const RecordingIndex& index) {
  std::vector<UserState> out;
  for (const auto& [id, member] : people.members()) {
    if (member.role == Role::observer) continue;
    UserState& user = out.emplace_back();
    user.participant = id;
    user.time = simulation.time();
    user.input_sequence = user.time.tick;
    Vec3 sum = Vec3::Zero();
    int hands = 0;
    for (const HandState& state : simulation.hands()) {
      if (state.participant != id) continue;
      user.hands[state.hand] = {true, state.pose, state.flexion, Gesture::none, 0};
      sum += state.pose.p;
      ++hands;
    }
    const auto eyes = index.head_at(id, user.time.tick);
    user.head_tracked = eyes && hands > 0;
    if (user.head_tracked) user.head = look_at(*eyes, sum / hands);
  }
  return out;
}

}  // namespace prosector
