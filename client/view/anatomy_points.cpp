#include "client/view/anatomy_points.h"

namespace prosector {
namespace {

constexpr double near = 0.3;  // m, largest distance of a part from the soft bodies

Eigen::AlignedBox3d box_of(const std::vector<Vec3>& points) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : points) box.extend(x);
  return box;
}

/// Returns the points of a rigid body at its pose in the scene file.
std::vector<Vec3> points_of(const RigidReplica& body) {
  std::vector<Vec3> out;
  for (const Vec3& x : body.mesh.positions) out.push_back(body.scene_pose * x);
  return out;
}

}  // namespace

std::vector<Vec3> anatomy_points(Replica& replica) {
  std::vector<Vec3> soft, parts, moving;
  const auto append = [](std::vector<Vec3>& to, const std::vector<Vec3>& points) {
    to.insert(to.end(), points.begin(), points.end());
  };
  const auto& bodies = replica.scene()->bodies;
  for (BodyId id = 0; id < bodies.size(); ++id)
    if (const SoftReplica* body = bodies[id].kind == BodyKind::soft ? replica.bodies().soft(id) : nullptr)
      append(soft, body->rest().positions);
  const Eigen::AlignedBox3d tissue = box_of(soft);
  for (BodyId id = 0; id < bodies.size(); ++id) {
    const RigidReplica* body = bodies[id].kind == BodyKind::rigid ? replica.bodies().rigid(id) : nullptr;
    if (body == nullptr) continue;
    const std::vector<Vec3> points = points_of(*body);
    if (bodies[id].moves) append(moving, points);
    if (bodies[id].part && (soft.empty() || tissue.exteriorDistance(box_of(points)) < near))
      append(parts, points);
  }
  append(parts, soft);
  return parts.empty() ? moving : parts;
}

}  // namespace prosector
