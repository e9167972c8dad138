#include "server/physics/mechanics/rigid/collision_shape.h"

#include "server/physics/mechanics/collision/outlines/rigid_outline.h"

namespace prosector::rigid {
namespace {

constexpr double least_half = 5e-4;  // m: least half extent of a box around a flat part

collision::ShapePart to_part(const collision::CollisionPiece& piece, const Pose& to_body) {
  if (const auto* sphere = std::get_if<collision::SphereShape>(&piece))
    return {collision::ShapeKind::sphere,
            {sphere->radius, 0, 0},
            {to_body * sphere->center, Quat::Identity()},
            nullptr};
  const collision::BoxShape& box = std::get<collision::BoxShape>(piece);
  return {collision::ShapeKind::box, box.half.cwiseMax(least_half), to_body * box.pose, nullptr};
}

}  // namespace

std::vector<collision::ShapePart> at_fidelity(std::vector<collision::ShapePart> parts, Fidelity fidelity,
                                              const Pose& pose) {
  switch (fidelity) {
    case Fidelity::none:
      return {};
    case Fidelity::hull:
    case Fidelity::mesh:
      return parts;
    case Fidelity::sphere:
    case Fidelity::aabb:
    case Fidelity::obb:
      break;
  }
  const collision::RigidOutline outline(std::move(parts), fidelity);
  std::vector<collision::CollisionPiece> pieces;
  outline.place(pose, outline.rest_poses(), pieces);
  std::vector<collision::ShapePart> out;
  for (const collision::CollisionPiece& piece : pieces) out.push_back(to_part(piece, pose.inverse()));
  return out;
}

}  // namespace prosector::rigid
