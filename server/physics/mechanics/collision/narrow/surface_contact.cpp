#include "server/physics/mechanics/collision/narrow/surface_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "server/physics/mechanics/collision/primitives/triangle_crossing.h"
#include "server/physics/mechanics/collision/surface/surface_pairs.h"

namespace prosector::collision {
namespace {

/// A surface transformed into the other surface's frame.
struct InFrame {
  const TriangleSurface& surface;
  Mat3 rotation;
  Vec3 shift;

  InFrame(const TriangleSurface& of, const Pose& pose)
      : surface(of), rotation(pose.q.toRotationMatrix()), shift(pose.p) {}
  Vec3 operator()(const Vec3& x) const { return rotation * x + shift; }
  Triangle triangle(std::uint32_t t) const {
    const Triangle c = surface.triangle(t);
    return {(*this)(c[0]), (*this)(c[1]), (*this)(c[2])};
  }
};

/// Intersection of an edge with the other surface; `along`: position on the edge in [0, 1], from its lower
/// vertex.
struct Cut {
  std::uint32_t from, to;  // vertices, from < to
  double along;
  bool operator<(const Cut& c) const { return std::tie(from, to, along) < std::tie(c.from, c.to, c.along); }
};

struct Crossings {
  bool any = false;
  // The crossing pair in which b's normal is most parallel to the line between the box centres; `facing` is
  // the absolute cosine times that line's length.
  std::uint32_t triangle_a = 0, triangle_b = 0;
  double facing = -1;
  Vec3 point = Vec3::Zero();  // in a's frame
  std::vector<Cut> of_a, of_b;
};

Cut cut_of(const TriangleSurface& surface, std::uint32_t triangle, const Piercing& p) {
  const auto& c = surface.topology().triangles()[triangle];
  const std::uint32_t from = c[p.edge], to = c[(p.edge + 1u) % 3];
  return from < to ? Cut{from, to, p.along} : Cut{to, from, 1 - p.along};
}

/// Calls f(triangle of a, its corners, triangle of b, its corners in a's frame) for all pairs in leaves whose
/// boxes' squared distance is at most `limit()`.
template <class Limit, class F>
void near_triangles(const TriangleSurface& a, const InFrame& b, const Limit& limit, const F& f) {
  std::array<Triangle, SurfaceTree::leaf_triangles> in_frame;
  descend_pairs(a.tree(), b.surface.tree(), b.rotation, b.shift, limit,
                [&](const SurfaceTree::Node& p, const SurfaceTree::Node& q) {
                  for (std::uint32_t j = q.begin; j < q.end; ++j)
                    in_frame[j - q.begin] = b.triangle(b.surface.tree().order()[j]);
                  for (std::uint32_t i = p.begin; i < p.end; ++i) {
                    const std::uint32_t ta = a.tree().order()[i];
                    const Triangle of_a = a.triangle(ta);
                    for (std::uint32_t j = q.begin; j < q.end; ++j)
                      f(ta, of_a, b.surface.tree().order()[j], in_frame[j - q.begin]);
                  }
                });
}

Crossings find_crossings(const TriangleSurface& a, const InFrame& b) {
  Crossings out;
  const Vec3 way = a.box().center() - b(b.surface.box().center());
  near_triangles(
      a, b, [] { return 0.0; },
      [&](std::uint32_t ta, const Triangle& of_a, std::uint32_t tb, const Triangle& of_b) {
        const TriangleCrossing found = crossing(of_a, of_b);
        if (!found.crosses) return;
        const Vec3 normal = (of_b[1] - of_b[0]).cross(of_b[2] - of_b[0]);
        const double facing = normal.norm() > 0 ? std::abs(way.dot(normal.normalized())) : 0;
        const bool earlier = std::pair{ta, tb} < std::pair{out.triangle_a, out.triangle_b};
        if (facing > out.facing || (facing == out.facing && earlier)) {
          out.facing = facing;
          out.triangle_a = ta;
          out.triangle_b = tb;
          out.point = found.count > 0 ? found.piercings[0].point : closest(of_a, of_b).on_a;
        }
        out.any = true;
        for (std::size_t k = 0; k < found.count; ++k) {
          const Piercing& piercing = found.piercings[k];
          if (piercing.of_a)
            out.of_a.push_back(cut_of(a, ta, piercing));
          else
            out.of_b.push_back(cut_of(b.surface, tb, piercing));
        }
      });
  std::sort(out.of_a.begin(), out.of_a.end());
  std::sort(out.of_b.begin(), out.of_b.end());
  return out;
}

/// Deepest point found so far of one surface inside the other, in the other surface's frame.
struct Deepest {
  double depth = -1;  // m
  Vec3 point = Vec3::Zero();
  SurfacePoint at;       // the point on the penetrating surface
  NearestPoint nearest;  // its closest point on the other surface

  void offer(const Vec3& x, const SurfacePoint& where, const TriangleSurface& other) {
    const std::optional<NearestPoint> near = other.nearest(x);
    if (!near || !(near->distance > depth) || !other.is_inside(x, *near)) return;
    *this = {near->distance, x, where, *near};
  }
};

SurfacePoint at_vertex(const SurfaceTopology& topology, std::uint32_t vertex) {
  const std::uint32_t t = topology.around(vertex).front();
  const auto& c = topology.triangles()[t];
  return {t, Vec3::Unit(c[0] == vertex ? 0 : c[1] == vertex ? 1 : 2)};
}

/// Offers the vertices of `one` inside `other` as deepest points. Skips a box if the signed depth of its
/// centre plus its half diagonal does not exceed the best depth: signed distance is 1-Lipschitz.
void offer_corners(const InFrame& one, const TriangleSurface& other, Deepest& best) {
  const SurfaceTopology& topology = one.surface.topology();
  one.surface.tree().visit(
      [&](const Aabb& box) {
        const Aabb moved = transformed(box, one.rotation, one.shift);
        if (!moved.overlaps(other.box())) return false;
        const Vec3 middle = moved.center();
        const double reach = box.half().norm();
        const std::optional<NearestPoint> near = other.nearest(middle);
        if (!near) return false;
        const double depth = other.is_inside(middle, *near) ? near->distance : -near->distance;
        return depth + reach > best.depth;
      },
      [&](const SurfaceTree::Node& node) {
        for (std::uint32_t i = node.begin; i < node.end; ++i) {
          const std::uint32_t t = one.surface.tree().order()[i];
          for (const std::uint32_t v : topology.triangles()[t])
            if (topology.around(v).front() == t)  // visits each vertex once
              best.offer(one(one.surface.positions()[v]), at_vertex(topology, v), other);
        }
      });
}

/// Offers samples of `one`'s edges between two adjacent crossings. Skips segments of which half the length, a
/// bound on the depth, does not exceed the best depth.
void offer_cut_edges(const InFrame& one, const std::vector<Cut>& cuts, const TriangleSurface& other,
                     Deepest& best) {
  constexpr int samples = 7;  // per segment
  const SurfaceTopology& topology = one.surface.topology();
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const Cut &c = cuts[i], &d = cuts[i + 1];
    if (c.from != d.from || c.to != d.to) continue;
    const Vec3 p = one(one.surface.positions()[c.from]), q = one(one.surface.positions()[c.to]);
    if (!((d.along - c.along) * (q - p).norm() / 2 > best.depth)) continue;
    SurfacePoint from = at_vertex(topology, c.from);
    for (const std::uint32_t t : topology.around(c.from)) {
      const auto& corners = topology.triangles()[t];
      if (std::find(corners.begin(), corners.end(), c.to) != corners.end()) from.triangle = t;
    }
    const auto& corners = topology.triangles()[from.triangle];
    for (int k = 1; k <= samples; ++k) {
      const double along = c.along + (d.along - c.along) * k / (samples + 1);
      for (std::size_t j = 0; j < 3; ++j)
        from.weights[static_cast<Eigen::Index>(j)] = corners[j] == c.from ? 1 - along
                                                     : corners[j] == c.to ? along
                                                                          : 0;
      best.offer(p + along * (q - p), from, other);
    }
  }
}

/// Returns whether a connected piece of `one` is inside `other`. The surfaces must not cross, so one vertex
/// of each piece is enough.
bool some_piece_inside(const InFrame& one, const TriangleSurface& other) {
  if (!other.topology().closed()) return false;
  const auto pieces = one.surface.topology().pieces();
  return std::any_of(pieces.begin(), pieces.end(), [&](std::uint32_t v) {
    const Vec3 x = one(one.surface.positions()[v]);
    if (!(other.box().squared_distance(x) <= 0)) return false;
    const auto near = other.nearest(x);
    return near && other.is_inside(x, *near);
  });
}

/// Returns the direction to the closest point outside; the surface normal if the distance is too short to
/// define a direction.
Vec3 way_out(const Deepest& deepest, const TriangleSurface& other) {
  const Vec3 way = deepest.nearest.point - deepest.point;
  const double length = way.norm();
  if (length > 1e-9 * other.box().half().norm()) return way / length;
  const Vec3 normal = other.normal_at(deepest.nearest.triangle, deepest.nearest.weights);
  return normal.isZero(0) ? Vec3(Vec3::UnitY()) : normal;
}

/// Returns the proximity of a crossing without depth. The normal is that of b's triangle, on the side of a's
/// box centre.
Proximity crossing_without_depth(const TriangleSurface& a, const InFrame& b, const Crossings& found) {
  Proximity out;
  const Triangle t = b.triangle(found.triangle_b);
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  if (normal.norm() > 0) out.normal = normal.normalized();
  if (out.normal.dot(a.box().center() - found.point) < 0) out.normal = -out.normal;
  out.on_a = out.on_b = found.point;
  const Triangle of_a = a.triangle(found.triangle_a);
  out.at_a = {found.triangle_a, closest_weights(found.point, of_a[0], of_a[1], of_a[2])};
  out.at_b = {found.triangle_b, closest_weights(found.point, t[0], t[1], t[2])};
  return out;
}

/// Returns the depth of crossing surfaces, in a's frame.
Proximity depth_of(const InFrame& a_in_b, const InFrame& b, const Crossings& found) {
  const TriangleSurface& a = a_in_b.surface;
  Deepest of_a, of_b;
  if (b.surface.topology().closed()) {
    offer_corners(a_in_b, b.surface, of_a);
    offer_cut_edges(a_in_b, found.of_a, b.surface, of_a);
  }
  of_b.depth = of_a.depth;
  if (a.topology().closed()) {
    offer_corners(b, a, of_b);
    offer_cut_edges(b, found.of_b, a, of_b);
  }
  Proximity out;
  if (of_b.depth > of_a.depth) {
    out.gap = -of_b.depth;
    out.normal = -way_out(of_b, a);
    out.on_b = of_b.point;
    out.on_a = of_b.nearest.point;
    out.at_b = of_b.at;
    out.at_a = {of_b.nearest.triangle, of_b.nearest.weights};
  } else if (of_a.depth >= 0) {
    out.gap = -of_a.depth;
    out.normal = b.rotation * way_out(of_a, b.surface);
    out.on_a = b(of_a.point);
    out.on_b = b(of_a.nearest.point);
    out.at_a = of_a.at;
    out.at_b = {of_a.nearest.triangle, of_a.nearest.weights};
  } else {
    out = crossing_without_depth(a, b, found);
  }
  return out;
}

/// Returns the distance of separated surfaces, in a's frame.
std::optional<Proximity> distance_of(const TriangleSurface& a, const InFrame& b, double limit) {
  TrianglePair best;
  std::uint32_t triangle_a = 0, triangle_b = 0;
  double squared = limit * limit;
  bool found = false;
  near_triangles(
      a, b, [&] { return squared; },
      [&](std::uint32_t ta, const Triangle& of_a, std::uint32_t tb, const Triangle& of_b) {
        const TrianglePair pair = closest(of_a, of_b);
        const bool later = found && std::pair{ta, tb} > std::pair{triangle_a, triangle_b};
        if (pair.squared_distance > squared || (pair.squared_distance == squared && later)) return;
        best = pair;
        triangle_a = ta;
        triangle_b = tb;
        squared = pair.squared_distance;
        found = true;
      });
  if (!found) return std::nullopt;
  Proximity out;
  out.gap = std::sqrt(squared);
  out.on_a = best.on_a;
  out.on_b = best.on_b;
  out.at_a = {triangle_a, best.weights_a};
  out.at_b = {triangle_b, best.weights_b};
  if (out.gap > 0)
    out.normal = (out.on_a - out.on_b) / out.gap;
  else
    out.normal = b.rotation * b.surface.normal_at(triangle_b, best.weights_b);
  return out;
}

Proximity in_room(Proximity p, const Pose& frame) {
  p.normal = frame.q * p.normal;
  p.on_a = frame * p.on_a;
  p.on_b = frame * p.on_b;
  return p;
}

}  // namespace

std::optional<Proximity> surface_proximity(const MeshShape& a, const MeshShape& b, double margin) {
  const InFrame in_a(*b.surface, a.pose.inverse() * b.pose);
  const InFrame a_in_b(*a.surface, b.pose.inverse() * a.pose);
  const Crossings found = find_crossings(*a.surface, in_a);
  std::optional<Proximity> out;
  if (found.any || some_piece_inside(a_in_b, *b.surface) || some_piece_inside(in_a, *a.surface))
    out = depth_of(a_in_b, in_a, found);
  else
    out = distance_of(*a.surface, in_a, std::max(0.0, margin + a.rounding + b.rounding));
  if (!out) return std::nullopt;
  out = rounded(in_room(*out, a.pose), a.rounding, b.rounding);
  if (!(out->gap <= margin)) return std::nullopt;
  return out;
}

std::optional<Proximity> sphere_surface_proximity(const SphereShape& a, const MeshShape& b, double margin) {
  const TriangleSurface& surface = *b.surface;
  const Vec3 center = b.pose.inverse() * a.center;
  const double reach = margin + a.radius + b.rounding;
  // A sphere centre inside a closed surface is in contact at any distance from the triangles.
  const bool within = surface.topology().closed() && surface.box().squared_distance(center) <= 0;
  const auto near =
      surface.nearest(center, within ? std::numeric_limits<double>::infinity() : std::max(0.0, reach));
  if (!near) return std::nullopt;
  const bool inside = surface.is_inside(center, *near);
  Proximity out;
  out.gap = inside ? -near->distance : near->distance;
  out.normal = surface.normal_at(near->triangle, near->weights);
  if (near->distance > 1e-12 * surface.box().half().norm())
    out.normal = (center - near->point) / out.gap;
  else if (out.normal.isZero(0))
    out.normal = Vec3::UnitY();
  out.on_a = center;
  out.on_b = near->point;
  out.at_b = {near->triangle, near->weights};
  out = rounded(in_room(out, b.pose), a.radius, b.rounding);
  if (!(out.gap <= margin)) return std::nullopt;
  return out;
}

}  // namespace prosector::collision
