#include "server/physics/mechanics/collision/outlines/rigid_outline.h"

#include <algorithm>

#include "common/error.h"

namespace prosector::collision {
namespace {

bool equal(const Pose& a, const Pose& b) {
  return a.p == b.p && a.q.coeffs() == b.q.coeffs();
}

}  // namespace

template <class Fit>
auto RigidOutline::fit(std::span<const Pose> part_poses, const Fit& fit) const {
  std::vector<std::vector<Vec3>> placed(parts_.size());
  std::vector<Cloud> clouds;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const Mat3 rotation = part_poses[i].q.toRotationMatrix();
    placed[i].reserve(parts_[i].outline.size());
    for (const Vec3& x : parts_[i].outline) placed[i].push_back(rotation * x + part_poses[i].p);
    clouds.push_back({placed[i], parts_[i].rounding});
  }
  return fit(std::span<const Cloud>(clouds));
}

RigidOutline::RigidOutline(std::vector<ShapePart> parts, Fidelity fidelity) : fidelity_(fidelity) {
  if (parts.empty()) throw InputError("collision shape: no parts; at least one is needed");
  for (const ShapePart& part : parts) parts_.push_back(make_part(part));
  const std::vector<Pose> rest = rest_poses();
  if (fidelity == Fidelity::sphere) rest_sphere_ = fit(rest, enclosing_sphere);
  if (fidelity == Fidelity::obb) rest_box_ = fit(rest, enclosing_oriented_box);
}

RigidOutline::Part RigidOutline::make_part(const ShapePart& shape) const {
  check_part(shape);
  if (!is_finite(shape.pose))
    throw InputError("collision part: its position or rotation is not a finite number");
  Part out{shape, nullptr, nullptr, {}, 0};
  const bool simple = shape.kind == ShapeKind::box || shape.kind == ShapeKind::sphere;
  switch (fidelity_) {
    case Fidelity::none:
      break;
    case Fidelity::sphere:
    case Fidelity::aabb:
    case Fidelity::obb:
      if (shape.kind == ShapeKind::hull || shape.kind == ShapeKind::triangles) {
        out.outline = PointHull(shape.mesh->positions).points();
      } else if (shape.kind == ShapeKind::sphere || shape.kind == ShapeKind::capsule) {
        const Vec3 end(0, shape.kind == ShapeKind::capsule ? shape.half.y() : 0, 0);
        out.outline = {-end, end};
        out.rounding = shape.half.x();
      } else {
        const auto surface = part_surface(shape);
        out.outline.assign(surface->positions().begin(), surface->positions().end());
      }
      break;
    case Fidelity::hull:
      if (!simple) out.convex = make_convex(shape);
      break;
    case Fidelity::mesh:
      out.surface = part_surface(shape);
  }
  return out;
}

std::vector<Pose> RigidOutline::rest_poses() const {
  std::vector<Pose> out;
  for (const Part& part : parts_) out.push_back(part.shape.pose);
  return out;
}

void RigidOutline::place(const Pose& pose, std::span<const Pose> part_poses,
                         std::vector<CollisionPiece>& out) const {
  out.clear();
  const auto at_rest = [&] {
    return std::equal(parts_.begin(), parts_.end(), part_poses.begin(), part_poses.end(),
                      [](const Part& part, const Pose& now) { return equal(part.shape.pose, now); });
  };
  switch (fidelity_) {
    case Fidelity::none:
      return;
    case Fidelity::sphere: {
      SphereShape sphere = at_rest() ? rest_sphere_ : fit(part_poses, enclosing_sphere);
      sphere.center = pose * sphere.center;
      out.emplace_back(sphere);
      return;
    }
    case Fidelity::aabb: {
      std::vector<Pose> in_room;
      for (const Pose& part : part_poses) in_room.push_back(pose * part);
      const Aabb box = fit(in_room, enclosing_box);
      out.emplace_back(BoxShape{{box.center(), Quat::Identity()}, box.half()});
      return;
    }
    case Fidelity::obb: {
      BoxShape box = at_rest() ? rest_box_ : fit(part_poses, enclosing_oriented_box);
      box.pose = pose * box.pose;
      out.emplace_back(box);
      return;
    }
    case Fidelity::hull:
    case Fidelity::mesh:
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i];
        const Pose at = pose * part_poses[i];
        if (part.surface)
          out.emplace_back(MeshShape{part.surface, at, 0});
        else if (part.convex)
          out.emplace_back(ConvexShape{part.convex, at});
        else if (part.shape.kind == ShapeKind::box)
          out.emplace_back(BoxShape{at, part.shape.half});
        else
          out.emplace_back(SphereShape{at.p, part.shape.half.x()});
      }
  }
}

}  // namespace prosector::collision
