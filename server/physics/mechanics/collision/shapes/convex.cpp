#include "server/physics/mechanics/collision/shapes/convex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.h"
#include "common/scene/primitives.h"

namespace prosector::collision {
namespace {

// Points this close to a face, relative to the extent, may be corners of the exact hull. Bullet's hull
// computer rounds coordinates to one part in 10,216 of the extent (btConvexHullComputer.cpp).
constexpr double hull_rounding = 3e-4;

std::shared_ptr<const TriangleSurface> shared_surface(const TriangleMesh& mesh) {
  return std::make_shared<TriangleSurface>(mesh);
}

Aabb box_of(const std::vector<Vec3>& points) {
  Aabb box;
  for (const Vec3& x : points) box.add(x);
  return box;
}

/// Returns the points that may be corners of their convex hull.
std::vector<Vec3> outer_points(const std::vector<Vec3>& points) {
  if (points.empty()) throw InputError("collision hull: no points; at least one is needed");
  const Aabb box = box_of(points);
  const double near = hull_rounding * (box.hi - box.lo).maxCoeff();
  const TriangleMesh hull = convex_hull(points);
  std::vector<Vec3> normals;
  std::vector<double> offsets;
  for (const auto& t : hull.triangles) {
    const Vec3& a = hull.positions[t[0]];
    const Vec3 normal = (hull.positions[t[1]] - a).cross(hull.positions[t[2]] - a);
    if (!(normal.norm() > 0)) continue;
    normals.push_back(normal.normalized());
    offsets.push_back(normals.back().dot(a));
  }
  std::vector<Vec3> out;
  for (const Vec3& x : points) {
    bool outer = normals.empty();
    for (std::size_t i = 0; i < normals.size() && !outer; ++i) outer = normals[i].dot(x) - offsets[i] > -near;
    if (outer) out.push_back(x);
  }
  return out;
}

TriangleMesh hull_mesh(const std::vector<Vec3>& points) {
  TriangleMesh hull = convex_hull(points);
  std::erase_if(hull.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  for (Vec3& x : hull.positions)
    x = *std::min_element(points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) {
      return (a - x).squaredNorm() < (b - x).squaredNorm();
    });
  if (hull.triangles.empty()) {  // the points form a point or a line
    hull.positions = {points.front(), points[points.size() / 2], points.back()};
    hull.triangles = {{0, 1, 2}};
  }
  return hull;
}

/// Convex capsule, cylinder or ellipsoid.
class RoundConvex final : public FacetedConvex {
 public:
  explicit RoundConvex(const ShapePart& part)
      : FacetedConvex(Vec3::Zero(), core_reach(part), part.kind == ShapeKind::capsule ? part.half.x() : 0),
        kind_(part.kind),
        half_(part.half),
        faces_(part_surface(part)) {}

  Vec3 farthest(const Vec3& direction) const override {
    const double along = direction.y() < 0 ? -half_.y() : half_.y();
    if (kind_ == ShapeKind::capsule) return {0, along, 0};
    if (kind_ == ShapeKind::cylinder) {
      const double across = std::hypot(direction.x(), direction.z());
      const double scale = across > 0 ? half_.x() / across : 0;
      return {scale * direction.x(), along, scale * direction.z()};
    }
    const Vec3 scaled = half_.cwiseProduct(direction);
    const double length = scaled.norm();
    return length > 0 ? Vec3(half_.cwiseProduct(scaled) / length) : Vec3(half_.x(), 0, 0);
  }
  std::shared_ptr<const TriangleSurface> faces() const override { return faces_; }

 private:
  static double core_reach(const ShapePart& part) {
    if (part.kind == ShapeKind::capsule) return part.half.y();
    if (part.kind == ShapeKind::cylinder) return std::hypot(part.half.x(), part.half.y());
    return part.half.maxCoeff();
  }

  ShapeKind kind_;
  Vec3 half_;
  std::shared_ptr<const TriangleSurface> faces_;
};

PartDesc description(const ShapePart& part) {
  PartDesc out;
  out.size = 2 * part.half;
  switch (part.kind) {
    case ShapeKind::box:
      break;
    case ShapeKind::sphere:
      out.shape = "sphere";
      out.size = Vec3::Constant(2 * part.half.x());
      break;
    case ShapeKind::capsule:
      out.shape = "capsule";
      out.size = {2 * part.half.x(), 2 * (part.half.y() + part.half.x()), 2 * part.half.x()};
      break;
    case ShapeKind::cylinder:
      out.shape = "cylinder";
      out.size.z() = out.size.x();
      break;
    default:
      out.shape = "ellipsoid";
  }
  return out;
}

bool is_mesh(const ShapePart& part) {
  return part.kind == ShapeKind::hull || part.kind == ShapeKind::triangles;
}

}  // namespace

void check_part(const ShapePart& part) {
  if (is_mesh(part)) {
    if (!part.mesh || part.mesh->positions.empty())
      throw InputError("collision part: its mesh has no vertices; at least one is needed");
    for (const Vec3& x : part.mesh->positions)
      if (!is_finite(x))
        throw InputError("collision part: a coordinate of a mesh vertex is not a finite number");
    return;
  }
  Vec3 needed = part.half;
  if (part.kind == ShapeKind::sphere) needed = Vec3::Constant(part.half.x());
  if (part.kind == ShapeKind::cylinder) needed.z() = part.half.x();
  // A capsule's segment may have length zero.
  if (part.kind == ShapeKind::capsule)
    needed = {part.half.x(), part.half.y() == 0 ? 1 : part.half.y(), part.half.x()};
  if (!needed.allFinite() || !(needed.minCoeff() > 0))
    throw InputError(
        fmt::format("collision part: half sizes {} × {} × {} m; each must be positive and finite",
                    part.half.x(), part.half.y(), part.half.z()));
}

PointHull::PointHull(const std::vector<Vec3>& points) : PointHull(outer_points(points), box_of(points)) {}

PointHull::PointHull(std::vector<Vec3> outer, const Aabb& box)
    : FacetedConvex(box.center(), box.half().norm(), 0),
      points_(std::move(outer)),
      faces_(shared_surface(hull_mesh(points_))) {}

Vec3 PointHull::farthest(const Vec3& direction) const {
  std::size_t best = 0;
  double height = direction.dot(points_[0]);
  for (std::size_t i = 1; i < points_.size(); ++i)
    if (const double h = direction.dot(points_[i]); h > height) {
      height = h;
      best = i;
    }
  return points_[best];
}

std::shared_ptr<const TriangleSurface> SurfaceHull::faces() const {
  const std::vector<Vec3> points(surface_->positions().begin(), surface_->positions().end());
  return shared_surface(hull_mesh(points));
}

std::shared_ptr<const FacetedConvex> make_convex(const ShapePart& part) {
  check_part(part);
  if (is_mesh(part)) return std::make_shared<PointHull>(part.mesh->positions);
  return std::make_shared<RoundConvex>(part);
}

std::shared_ptr<const TriangleSurface> part_surface(const ShapePart& part) {
  check_part(part);
  if (part.kind == ShapeKind::box) return box_surface(part.half);
  return shared_surface(is_mesh(part) ? *part.mesh : mesh_of(description(part)));
}

std::shared_ptr<const TriangleSurface> box_surface(const Vec3& half) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.positions.emplace_back(
        half.cwiseProduct(Vec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return shared_surface(mesh);
}

}  // namespace prosector::collision
