#include "server/session/sending/collision_model.h"

#include "common/fidelity.h"
#include "common/scene/primitives.h"
#include "server/physics/mechanics/collision/outlines/bounding.h"
#include "server/physics/mechanics/collision/shapes/shape.h"

namespace prosector {
namespace {

TriangleMesh outline(const collision::SphereShape& sphere) {
  PartDesc part;
  part.shape = "sphere";
  part.size = Vec3::Constant(2 * sphere.radius);
  part.pose.p = sphere.center;
  return mesh_of(part);
}

TriangleMesh outline(const collision::BoxShape& box) {
  PartDesc part;
  part.size = 2 * box.half;
  part.pose = box.pose;
  return mesh_of(part);
}

}  // namespace

std::optional<TriangleMesh> collision_outline(const RigidDesc& body, const TriangleMesh& surface) {
  if (surface.positions.empty()) return std::nullopt;
  const collision::Cloud cloud{surface.positions};
  switch (body.contact.collision) {
    case Fidelity::none:
    case Fidelity::mesh:
      return std::nullopt;
    case Fidelity::hull:
      if (!body.geometry.parts.empty()) return std::nullopt;  // each part is convex
      return collision::convex_hull(surface.positions);
    case Fidelity::sphere:
      return outline(collision::enclosing_sphere({&cloud, 1}));
    case Fidelity::aabb:
      return outline(collision::enclosing_box_along(body.pose.q.conjugate(), {&cloud, 1}));
    case Fidelity::obb:
      return outline(collision::enclosing_oriented_box({&cloud, 1}));
  }
  return std::nullopt;
}

}  // namespace prosector
