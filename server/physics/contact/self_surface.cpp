#include "server/physics/contact/self_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace prosector {
namespace {

constexpr double apart = 2.5;         // cells at rest: what is farther may fold onto each other …
constexpr double through = 0.5;       // cosine: … unless the way there leads through the body
constexpr double across = 0.3;        // cosine: what looks at each other may meet from …
constexpr double least_across = 0.5;  // … so many cells on
constexpr double least_facing = 0.3;  // cosine, of both surfaces to the way out
constexpr double deepest = 1;         // cells; and of a wall no more than half
constexpr double most_margin = 2;     // cells
constexpr double spare = 1;           // cells, that the list reaches farther than it must

/// Twice the area long.
Vec3 normal(const TriangleMesh& surface, const std::array<std::uint32_t, 3>& t) {
  const Vec3& x = surface.positions[t[0]];
  return (surface.positions[t[1]] - x).cross(surface.positions[t[2]] - x);
}

double mean_edge(const TriangleMesh& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += (surface.positions[t[(k + 1) % 3]] - surface.positions[t[k]]).norm();
  return sum / (3 * static_cast<double>(surface.triangles.size()));
}

/// m: volume over area; of a plate half its thickness.
double half_wall(const TriangleMesh& surface) {
  double volume = 0, area = 0;
  for (const auto& t : surface.triangles) {
    const Vec3 n = normal(surface, t);
    volume += n.dot(surface.positions[t[0]]) / 6;
    area += n.norm() / 2;
  }
  return volume / area;
}

}  // namespace

SelfSurface::SelfSurface(const Anatomy& anatomy)
    : anatomy_(&anatomy),
      cell_(mean_edge(anatomy.surface)),
      deepest_(std::min(deepest * cell_, half_wall(anatomy.surface))) {
  const TriangleMesh& surface = anatomy.surface;
  outward_.assign(surface.positions.size(), Vec3::Zero());
  for (const auto& t : surface.triangles) {
    const Vec3 n = normal(surface, t);
    for (const std::uint32_t corner : t) outward_[corner] += n;
    normals_.push_back(n.normalized());
    middles_.push_back((surface.positions[t[0]] + surface.positions[t[1]] + surface.positions[t[2]]) / 3);
  }
  for (Vec3& n : outward_) n.normalize();
}

bool SelfSurface::may_meet(std::uint32_t vertex, std::uint32_t triangle) const {
  const Vec3 way = middles_[triangle] - anatomy_->surface.positions[vertex];
  const double distance = way.norm();
  if (distance < least_across * cell_) return false;
  const double out = outward_[vertex].dot(way), in = -normals_[triangle].dot(way);
  const bool facing = std::min(out, in) > across * distance;
  const bool far = distance > apart * cell_ && std::max(out, in) > -through * distance;
  return (facing || far) && !share_nodes(vertex, triangle);
}

/// What hangs on the same nodes can't move apart.
bool SelfSurface::share_nodes(std::uint32_t vertex, std::uint32_t triangle) const {
  const auto& rows = anatomy_->embedding.rows;
  ContactSide face;
  for (const std::uint32_t corner : anatomy_->surface.triangles[triangle]) face.add(rows[corner], 1);
  const auto end = face.node.begin() + static_cast<std::ptrdiff_t>(face.nodes);
  for (std::size_t k = 0; k < 4; ++k)
    if (rows[vertex].weight[k] != 0 && std::find(face.node.begin(), end, rows[vertex].node[k]) != end)
      return true;
  return false;
}

double SelfSurface::neared(std::span<const Vec3> positions) const {
  Vec3 shift = Vec3::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i) shift += positions[i] - listed_at_[i];
  shift /= static_cast<double>(positions.size());
  double most = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    most = std::max(most, (positions[i] - listed_at_[i] - shift).squaredNorm());
  return 2 * std::sqrt(most);
}

void SelfSurface::list(const SoftSkin& own, double reach) {
  const auto positions = own.vertices->positions();
  listed_at_.assign(positions.begin(), positions.end());
  reach_ = reach;
  near_.clear();
  const SurfaceTree& tree = own.faces->tree();
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) {
    const Aabb box = Aabb{positions[vertex], positions[vertex]}.grown(reach);
    const std::size_t first = near_.size();
    tree.visit([&](const Aabb& other) { return box.overlaps(other); },
               [&](const SurfaceTree::Node& leaf) {
                 for (std::uint32_t k = leaf.begin; k < leaf.end; ++k)
                   if (may_meet(vertex, tree.order()[k])) near_.emplace_back(vertex, tree.order()[k]);
               });
    std::sort(near_.begin() + static_cast<std::ptrdiff_t>(first), near_.end());
  }
}

void SelfSurface::find(const SoftSkin& own, double margin, std::vector<VertexMeeting>& out) {
  const auto positions = own.vertices->positions();
  margin = std::min(margin, most_margin * cell_);
  const double reach = std::max(margin, deepest_);
  if (listed_at_.empty() || !(reach + neared(positions) <= reach_)) list(own, reach + spare * cell_);
  for (std::size_t i = 0; i < near_.size();) {
    const std::uint32_t vertex = near_[i].first;
    const Vec3 &x = positions[vertex], facing = own.vertices->outward_at(vertex);
    std::optional<VertexMeeting> nearest;
    for (; i < near_.size() && near_[i].first == vertex; ++i) {
      const std::uint32_t triangle = near_[i].second;
      const Triangle corners = own.faces->triangle(triangle);
      const Vec3 weights = closest_weights(x, corners[0], corners[1], corners[2]);
      const Vec3 away = x - at(corners, weights);
      const double distance = away.norm();
      if (!(distance <= reach) || (nearest && distance >= std::abs(nearest->gap))) continue;
      const Vec3 outward = own.faces->normal_at(triangle, weights);
      const bool inside = away.dot(outward) < 0;
      if (distance > (inside ? deepest_ : margin)) continue;
      const Vec3 n = distance > 0 ? Vec3((inside ? -1 : 1) / distance * away) : outward;
      if (!(n.dot(outward) > least_facing && n.dot(facing) < -least_facing)) continue;
      nearest = {vertex, {triangle, weights}, n, inside ? -distance : distance};
    }
    if (nearest) out.push_back(*nearest);
  }
}

}  // namespace prosector
