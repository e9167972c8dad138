#include "server/physics/mechanics/rigid/collision_shape.h"

#include "server/physics/mechanics/collision/outlines/rigid_outline.h"

namespace prosector {
namespace {

constexpr double least_half = 5e-4;  // m: least half extent of a box around a flat part

ShapePart to_part(const CollisionPiece& piece, const Pose& to_body) {
  if (const auto* sphere = std::get_if<SphereShape>(&piece))
    return {ShapeKind::sphere, {sphere->radius, 0, 0}, {to_body * sphere->center, Quat::Identity()}, nullptr};
  const BoxShape& box = std::get<BoxShape>(piece);
  return {ShapeKind::box, box.half.cwiseMax(least_half), to_body * box.pose, nullptr};
}

}  // namespace

std::vector<ShapePart> at_fidelity(std::vector<ShapePart> parts, Fidelity fidelity, const Pose& pose) {
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
  const RigidOutline outline(std::move(parts), fidelity);
  std::vector<CollisionPiece> pieces;
  outline.place(pose, outline.rest_poses(), pieces);
  std::vector<ShapePart> out;
  for (const CollisionPiece& piece : pieces) out.push_back(to_part(piece, pose.inverse()));
  return out;
}

}  // namespace prosector
