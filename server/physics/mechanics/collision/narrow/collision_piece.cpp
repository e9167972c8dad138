#include "server/physics/mechanics/collision/narrow/collision_piece.h"

#include "server/physics/mechanics/collision/narrow/convex_contact.h"

namespace prosector::collision {
namespace {

using Result = std::optional<Proximity>;

MeshShape surface_of(const BoxShape& box) {
  return {box_surface(box.half), box.pose, 0};
}
MeshShape surface_of(const ConvexShape& shape) {
  return {shape.convex->faces(), shape.pose, shape.convex->faces_rounding()};
}

// Kernels in the order of the table in the header; the other pairs swap a and b.
struct Kernels {
  double margin;
  Result operator()(const SphereShape& a, const SphereShape& b) const {
    return sphere_proximity(a, b, margin);
  }
  Result operator()(const SphereShape& a, const BoxShape& b) const {
    return sphere_box_proximity(a, b, margin);
  }
  Result operator()(const SphereShape& a, const ConvexShape& b) const {
    return convex_proximity(ConvexBall(a.center, a.radius), {}, *b.convex, b.pose, margin);
  }
  Result operator()(const SphereShape& a, const MeshShape& b) const {
    return sphere_surface_proximity(a, b, margin);
  }
  Result operator()(const BoxShape& a, const BoxShape& b) const { return box_proximity(a, b, margin); }
  Result operator()(const BoxShape& a, const ConvexShape& b) const {
    return convex_proximity(ConvexBox(a.half), a.pose, *b.convex, b.pose, margin);
  }
  Result operator()(const ConvexShape& a, const ConvexShape& b) const {
    return convex_proximity(*a.convex, a.pose, *b.convex, b.pose, margin);
  }
  Result operator()(const MeshShape& a, const MeshShape& b) const { return surface_proximity(a, b, margin); }
  Result operator()(const BoxShape& a, const MeshShape& b) const { return faceted(a, b); }
  Result operator()(const ConvexShape& a, const MeshShape& b) const { return faceted(a, b); }
  /// Returns the proximity of a shape's faces to a mesh. Clears `at_a`: the caller does not know the
  /// triangles generated for the shape.
  template <class Shape>
  Result faceted(const Shape& a, const MeshShape& b) const {
    Result out = surface_proximity(surface_of(a), b, margin);
    if (out) out->at_a = {};
    return out;
  }
  template <class A, class B>
  Result operator()(const A& a, const B& b) const {
    const Result out = (*this)(b, a);
    return out ? Result(out->flipped()) : out;
  }
};

Aabb box_around(const SphereShape& s) {
  return Aabb{s.center, s.center}.grown(s.radius);
}
Aabb box_around(const BoxShape& b) {
  return transformed({-b.half, b.half}, b.pose.q.toRotationMatrix(), b.pose.p);
}
Aabb box_around(const ConvexShape& s) {
  const Mat3 rotation = s.pose.q.toRotationMatrix();
  Aabb box;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vec3 axis = rotation.row(k);
    box.lo[k] = axis.dot(s.convex->farthest(-axis)) + s.pose.p[k];
    box.hi[k] = axis.dot(s.convex->farthest(axis)) + s.pose.p[k];
  }
  return box.grown(s.convex->rounding());
}
Aabb box_around(const MeshShape& s) {
  return transformed(s.surface->box(), s.pose.q.toRotationMatrix(), s.pose.p).grown(s.rounding);
}

}  // namespace

std::optional<Proximity> proximity(const CollisionPiece& a, const CollisionPiece& b, double margin) {
  return std::visit(Kernels{margin}, a, b);
}

Aabb box_of(const CollisionPiece& piece) {
  return std::visit([](const auto& shape) { return box_around(shape); }, piece);
}

}  // namespace prosector::collision
