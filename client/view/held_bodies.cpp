#include "client/view/held_bodies.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr double slender = 5;         // minimum ratio of length to width
constexpr double longest_held = 0.5;  // m, longest held instrument

bool is_instrument(const SceneBody& body, const RigidReplica& rigid) {
  if (body.appearance.surface == Surface::bone || body.appearance.surface == Surface::tissue) return false;
  Eigen::AlignedBox3d box;
  for (const Vec3& x : rigid.mesh.positions) box.extend(x);
  if (box.isEmpty()) return false;
  Vec3 size = box.sizes();
  std::sort(size.data(), size.data() + 3);
  return size[2] <= longest_held && size[2] >= slender * size[1];
}

}  // namespace

std::vector<BodyId> held_by(const Replica& replica, const HandRef& hand) {
  std::vector<BodyId> out;
  for (BodyId id = 0; id < replica.scene()->bodies.size(); ++id)
    if (const PartState* part = replica.part(id);
        part != nullptr && std::ranges::find(part->holders, hand) != part->holders.end())
      out.push_back(id);
  return out;
}

std::optional<Vec3> instrument_tip(const Replica& replica, const HandRef& hand, double tick) {
  const auto user = replica.user(hand.participant, tick);
  if (!user || !user->hands[hand.hand].tracked) return std::nullopt;
  for (const BodyId id : held_by(replica, hand)) {
    const RigidReplica* rigid = replica.bodies().rigid(id);
    if (rigid == nullptr || !is_instrument(replica.scene()->bodies[id], *rigid)) continue;
    const Pose wrist_from_body = user->hands[hand.hand].pose.inverse() * replica.rigid_pose(id, tick);
    std::optional<Vec3> tip;
    for (const Vec3& x : rigid->mesh.positions)
      if (const Vec3 at = wrist_from_body * x; !tip || at.z() < tip->z()) tip = at;
    return tip;
  }
  return std::nullopt;
}

std::optional<BladeFrame> held_blade(const Replica& replica, const HandRef& hand, double tick) {
  const auto user = replica.user(hand.participant, tick);
  if (!user || !user->hands[hand.hand].tracked) return std::nullopt;
  for (const BodyId id : held_by(replica, hand)) {
    const RigidReplica* rigid = replica.bodies().rigid(id);
    if (rigid == nullptr) continue;
    if (const auto blade = blade_frame(*rigid))
      return user->hands[hand.hand].pose.inverse() * replica.rigid_pose(id, tick) * *blade;
  }
  return std::nullopt;
}

}  // namespace prosector
