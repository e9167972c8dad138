#include "server/physics/mechanics/contact/shape_touch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prosector::contact {
namespace {

constexpr int leaning_directions = 8;
constexpr double lean = 0.1;         // tangent of the tilt against the normal
constexpr double same_point = 1e-6;  // m

bool is_sphere(const collision::CollisionPiece& piece) {
  return std::holds_alternative<collision::SphereShape>(piece);
}

/// Returns the support point of the piece in that direction, room frame.
Vec3 farthest(const collision::CollisionPiece& piece, const Vec3& direction) {
  if (const auto* box = std::get_if<collision::BoxShape>(&piece))
    return box->pose * collision::ConvexBox(box->half).farthest(box->pose.q.conjugate() * direction);
  if (const auto* shape = std::get_if<collision::ConvexShape>(&piece))
    return shape->pose * shape->convex->farthest(shape->pose.q.conjugate() * direction) +
           shape->convex->rounding() * direction.normalized();
  const auto& mesh = std::get<collision::MeshShape>(piece);
  const std::uint32_t vertex = mesh.surface->farthest(mesh.pose.q.conjugate() * direction);
  return mesh.pose * mesh.surface->positions()[vertex];
}

void add_once(const ShapeTouch& touch, std::size_t first, std::vector<ShapeTouch>& out) {
  const bool known =
      std::any_of(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(),
                  [&](const ShapeTouch& t) { return (t.point - touch.point).norm() < same_point; });
  if (!known) out.push_back(touch);
}

/// Appends the contact points of two boxes. Enlarges a by `margin`, so that faces meet before they overlap.
void box_touches(collision::BoxShape a, const collision::BoxShape& b, double margin,
                 std::vector<ShapeTouch>& out) {
  a.half.array() += margin;
  const auto overlap = collision::box_overlap(a, b);
  if (!overlap) return;
  const Vec3& n = overlap->proximity.normal;
  const auto lowest = [&](const collision::BoxShape& box, double sign) {
    return n.dot(box.pose.p) + sign * box.half.dot((box.pose.q.conjugate() * n).cwiseAbs());
  };
  const double of_a = lowest(a, -1), of_b = lowest(b, 1);
  double lo = n.dot(overlap->patch[0]), hi = lo;
  for (std::size_t i = 1; i < overlap->count; ++i) {
    lo = std::min(lo, n.dot(overlap->patch[i]));
    hi = std::max(hi, n.dot(overlap->patch[i]));
  }
  const bool edges = overlap->count == 1, on_b = std::abs(hi - of_b) <= std::abs(lo - of_a);
  for (std::size_t i = 0; i < overlap->count; ++i) {
    const Vec3& x = overlap->patch[i];
    const double gap = edges ? overlap->proximity.gap : on_b ? of_a - n.dot(x) : n.dot(x) - of_b;
    if (gap <= 0) out.push_back({x, n, gap + margin});
  }
}

/// Returns the proximity of the point to the shape; the normal points from the shape to the point.
std::optional<collision::Proximity> from_point(const Vec3& x, const collision::CollisionPiece& shape,
                                               double margin) {
  return collision::proximity(collision::SphereShape{x, 0}, shape, margin);
}

/// Returns the contact of a corner of one shape with the other, whose supporting plane is at `height` along
/// `n`. Returns none if the corner is outside the other's face.
std::optional<ShapeTouch> from_corner(const Vec3& x, const collision::CollisionPiece& other, const Vec3& n,
                                      double height, double beside) {
  const double above = n.dot(x) - height;
  const auto found = from_point(x - above * n, other, beside);
  if (!found) return std::nullopt;
  return ShapeTouch{x, n, above + std::max(0.0, found->gap)};
}

void convex_touches(const collision::CollisionPiece& a, const collision::CollisionPiece& b, double margin,
                    std::vector<ShapeTouch>& out) {
  const auto deepest = collision::proximity(a, b, margin);
  if (!deepest) return;
  const std::size_t first = out.size();
  const Vec3& n = deepest->normal;
  out.push_back({deepest->on_a, n, deepest->gap});
  const double of_a = n.dot(farthest(a, -n)), of_b = n.dot(farthest(b, n));
  const double beside =
      lean * std::min(collision::box_of(a).half().norm(), collision::box_of(b).half().norm());
  const Vec3 u = n.unitOrthogonal(), v = n.cross(u);
  for (int k = 0; k < leaning_directions; ++k) {
    const double angle = 2 * std::numbers::pi * k / leaning_directions;
    const Vec3 aside = lean * (std::cos(angle) * u + std::sin(angle) * v);
    if (const auto t = from_corner(farthest(a, aside - n), b, n, of_b, beside); t && t->gap <= margin)
      add_once(*t, first, out);
    if (auto t = from_corner(farthest(b, aside + n), a, -n, -of_a, beside); t && t->gap <= margin) {
      t->normal = n;
      add_once(*t, first, out);
    }
  }
}

/// Appends the contact points of a convex shape and a mesh.
void mesh_touches(const collision::CollisionPiece& a, const collision::MeshShape& mesh, double margin,
                  std::vector<ShapeTouch>& out) {
  const std::size_t first = out.size();
  const collision::CollisionPiece b = mesh;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 way(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    if (const auto* box = std::get_if<collision::BoxShape>(&a)) way = box->pose.q * way;
    const Vec3 x = farthest(a, way);
    if (const auto found = from_point(x, b, margin)) add_once({x, found->normal, found->gap}, first, out);
  }
  const collision::Aabb near = collision::box_of(a).grown(margin);
  for (const Vec3& position : mesh.surface->positions()) {
    const Vec3 y = mesh.pose * position;
    if (near.squared_distance(y) > 0) continue;
    if (const auto found = from_point(y, a, margin)) out.push_back({y, -found->normal, found->gap});
  }
}

}  // namespace

void find_touches(const collision::CollisionPiece& a, const collision::CollisionPiece& b, double margin,
                  std::vector<ShapeTouch>& out) {
  const auto *box_a = std::get_if<collision::BoxShape>(&a), *box_b = std::get_if<collision::BoxShape>(&b);
  if (box_a && box_b) return box_touches(*box_a, *box_b, margin, out);
  if (is_sphere(a) || is_sphere(b)) {
    if (const auto found = collision::proximity(a, b, margin))
      out.push_back({found->on_a, found->normal, found->gap});
    return;
  }
  if (const auto* mesh = std::get_if<collision::MeshShape>(&b)) return mesh_touches(a, *mesh, margin, out);
  convex_touches(a, b, margin, out);
}

}  // namespace prosector::contact
