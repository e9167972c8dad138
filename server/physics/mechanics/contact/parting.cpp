#include "server/physics/mechanics/contact/parting.h"

#include <algorithm>

namespace prosector::contact {
namespace {

constexpr double deep = 0.25;  // cells: contacts do not stay deeper than this
constexpr double apart = 0.1;  // cells: depth below which separation ends
// s: after this time with a vertex that came through, bodies are led as wholes.
constexpr double through_seconds = 0.25;
// s: after this time deep inside without being pressed, bodies are led as wholes.
constexpr double deep_seconds = 0.5;
constexpr double steady = 0.7;  // cosine of the largest rotation of the direction in a tick
// Smallest norm of the sum of normals that defines a direction, as a fraction of the area inside.
constexpr double least_share = 0.2;

bool is_inside(const SoftSkin& to, const Vec3& x) {
  const auto near = to.faces->nearest(x);
  return near && to.faces->is_inside(x, *near);
}

/// Returns a third of the area vector (m², along the normals) of the triangles around the vertex.
Vec3 area_vector(const collision::TriangleSurface& faces, std::uint32_t vertex) {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t t : faces.topology().around(vertex)) {
    const collision::Triangle x = faces.triangle(t);
    sum += (x[1] - x[0]).cross(x[2] - x[0]) / 6;
  }
  return sum;
}

}  // namespace

bool may_be_immersed(const SoftSkin& from, const SoftSkin& to, std::span<const VertexMeeting> found) {
  if (from.faces == nullptr || to.faces == nullptr || from.skin > 0 || to.skin > 0) return false;
  if (found.empty()) {
    const Vec3& x = from.vertices->positions()[0];
    const collision::Aabb& box = to.faces->box();
    return (x.array() > box.lo.array()).all() && (x.array() < box.hi.array()).all() && is_inside(to, x);
  }
  return std::any_of(found.begin(), found.end(),
                     [&](const VertexMeeting& m) { return m.gap < -deep * std::min(from.cell, to.cell); });
}

Immersion find_immersion(const SoftSkin& from, const SoftSkin& to, Unsure of_from, Unsure of_to) {
  Immersion out;
  from.vertices->in_box(to.faces->box().lo, to.faces->box().hi, [&](std::uint32_t vertex) {
    if (!of_from.empty() && of_from[vertex]) return;
    const Vec3& x = from.vertices->positions()[vertex];
    const auto near = to.faces->nearest(x);
    if (!near || !to.faces->is_inside(x, *near)) return;
    // Near a fold the nearest face may give the wrong sign, so deep vertices are checked with the winding
    // number.
    if (near->distance > deep * std::min(from.cell, to.cell) && to.faces->winding_number(x) < 0.5) return;
    const auto& corners = to.faces->topology().triangles()[near->triangle];
    if (!of_to.empty() &&
        std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return of_to[corner] != 0; }))
      return;
    VertexMeeting& found = out.vertices.emplace_back();
    found.vertex = vertex;
    found.at = {near->triangle, near->weights};
    found.gap = -near->distance;
    found.normal = near->distance > 0 ? Vec3((near->point - x) / near->distance)
                                      : to.faces->normal_at(near->triangle, near->weights);
    out.deepest = std::max(out.deepest, near->distance);
    const Vec3 normal = area_vector(*from.faces, vertex);
    out.normals += normal;
    out.area += normal.norm();
  });
  return out;
}

bool is_deep(const Immersion& of_a, const Immersion& of_b, double cell) {
  return std::max(of_a.deepest, of_b.deepest) > deep * cell;
}

Vec3 way_apart(const Immersion& of_a, const Immersion& of_b, const Vec3& between_middles) {
  const Vec3 sum = of_b.normals - of_a.normals;
  if (sum.norm() > least_share * (of_a.area + of_b.area)) return sum.normalized();
  return between_middles.norm() > 0 ? between_middles.normalized() : Vec3(Vec3::UnitY());
}

bool came_through(const VertexMeeting& inside, const Vec3& along, double cell) {
  return inside.gap < -deep * cell && inside.normal.dot(along) < 0;
}

std::optional<Entanglement> lead_apart(const Immersion& of_a, const Immersion& of_b,
                                       const Vec3& between_middles, const Entanglement* before, bool pressed,
                                       double cell, double h) {
  const double deepest = std::max(of_a.deepest, of_b.deepest);
  if (deepest < apart * cell) return std::nullopt;
  Entanglement now = before != nullptr ? *before : Entanglement{};
  const Vec3 way = way_apart(of_a, of_b, between_middles);
  if (before == nullptr || way.dot(now.way) > steady) now.way = way;
  const auto any_through = [&](const Immersion& inside, const Vec3& along) {
    return std::any_of(inside.vertices.begin(), inside.vertices.end(),
                       [&](const VertexMeeting& m) { return came_through(m, along, cell); });
  };
  const bool through = any_through(of_a, now.way) || any_through(of_b, -now.way);
  now.whole = now.whole || deepest > deepest_meeting * cell ||
              now.seconds > (through ? through_seconds : deep_seconds);
  if (!now.whole && !through && (pressed || !is_deep(of_a, of_b, cell))) return std::nullopt;
  now.seconds += h;
  return now;
}

}  // namespace prosector::contact
