#include "client/view/body_wireframes.h"

namespace prosector {

void BodyWireframes::add(DrawList& list, Replica& replica, double tick) {
  const auto& bodies = replica.scene()->bodies;
  for (BodyId id = 0; id < bodies.size(); ++id) {
    const PartState* part = replica.part(id);
    if (part != nullptr && (part->hidden || part->inspected)) continue;  // not in contact
    if (bodies[id].kind == BodyKind::soft) {
      const SoftReplica* soft = replica.bodies().soft(id);
      if (soft != nullptr && soft->complete()) add_soft(list, *soft, id);
    } else if (const TriangleMesh* outline = replica.bodies().outline(id, bodies[id], replica.assets())) {
      add_rigid(list, *outline, id, replica.rigid_pose(id, tick));
    }
  }
}

void BodyWireframes::add_soft(DrawList& list, const SoftReplica& soft, BodyId body) {
  const auto [edges, is_new] = edges_.try_emplace(body);
  if (is_new || shapes_[body] != soft.shape()) edges->second = all_edges(soft.rest().triangles);
  shapes_[body] = soft.shape();
  add_wireframe(list, edges->second,
                [&](std::uint32_t v) -> Vec3 { return soft.surface()[v].cast<double>(); });
}

void BodyWireframes::add_rigid(DrawList& list, const TriangleMesh& outline, BodyId body, const Pose& pose) {
  const auto [edges, is_new] = edges_.try_emplace(body);
  if (is_new) edges->second = visible_edges(outline);
  add_wireframe(list, edges->second, [&](std::uint32_t v) -> Vec3 { return pose * outline.positions[v]; });
}

}  // namespace prosector
