#include "server/physics/mechanics/contact/self_collision.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/assert.h"

namespace prosector::contact {
namespace {

constexpr double far_apart = 2.5;     // cells, at rest: parts that don't face each other touch from here on
constexpr double through = 0.5;       // cosine: distant parts that both face away from each other don't touch
constexpr double facing_each = 0.3;   // cosine above which parts face each other
constexpr double least_across = 0.5;  // cells, at rest: parts that face each other touch from here on
constexpr double least_facing_of_own = 0.3;  // cosine between each surface normal and the contact normal
constexpr double deepest = 1;                // cells: search depth, also limited to half a wall thickness
constexpr double most_margin = 2;            // cells
constexpr double spare = 1;                  // cells: extra reach of the list

/// Returns the triangle's normal, with length twice its area.
Vec3 normal(const TriangleMesh& surface, const std::array<std::uint32_t, 3>& t) {
  const Vec3& x = surface.positions[t[0]];
  return (surface.positions[t[1]] - x).cross(surface.positions[t[2]] - x);
}

}  // namespace

double mean_edge(const TriangleMesh& surface) {
  if (surface.triangles.empty()) return 0;
  double sum = 0;
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      sum += (surface.positions[t[(k + 1) % 3]] - surface.positions[t[k]]).norm();
  return sum / (3 * static_cast<double>(surface.triangles.size()));
}

SelfCollision::SelfCollision(const Anatomy& anatomy, double cell) : anatomy_(&anatomy), cell_(cell) {
  const TriangleMesh& surface = anatomy.surface;
  outward_.assign(surface.positions.size(), Vec3::Zero());
  faces_.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) {
    faces_.push_back(face(t));
    for (const std::uint32_t corner : t) outward_[corner] += normal(surface, t);
  }
  for (Vec3& n : outward_) n.normalize();
  find_depth();
}

SelfCollision::Face SelfCollision::face(const std::array<std::uint32_t, 3>& t) const {
  const std::vector<Vec3>& x = anatomy_->surface.positions;
  const Vec3 n = normal(anatomy_->surface, t);
  return {(x[t[0]] + x[t[1]] + x[t[2]]) / 3, n.normalized(), n.norm() / 2, n.dot(x[t[0]]) / 6};
}

Vec3 SelfCollision::outward(std::uint32_t vertex, const SurfaceDetector& vertices) const {
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t triangle : vertices.around(vertex))
    sum += normal(anatomy_->surface, anatomy_->surface.triangles[triangle]);
  return sum.normalized();
}

/// Computes the search depth: at most half a wall thickness, since volume over area is half the thickness of
/// a plate.
void SelfCollision::find_depth() {
  double volume = 0, area = 0;
  for (const Face& face : faces_) {
    volume += face.pyramid;
    area += face.area;
  }
  deepest_ = std::min(deepest * cell_, volume / area);
}

void SelfCollision::follow(const SurfaceEdit& edit, const SurfaceDetector& vertices) {
  std::vector<Face> come;
  come.reserve(edit.corners.size());
  for (const auto& corners : edit.corners) come.push_back(face(corners));
  apply(edit.triangles, come, faces_);
  const std::vector<Vec3> unknown(edit.positions.size(), Vec3::Zero());
  apply(edit.vertices, unknown, outward_);
  for (const std::uint32_t vertex : edit.touched) outward_[vertex] = outward(vertex, vertices);
  find_depth();
  PROSECTOR_ASSERT(faces_.size() == anatomy_->surface.triangles.size() &&
                   outward_.size() == anatomy_->surface.positions.size());
  if (listed_at_.empty()) return;
  if (!changed_vertices_.empty()) {  // from an edit without a search since: rare
    forget_list();
    return;
  }
  apply(edit.vertices, unknown, listed_at_);
  new_vertices_ = edit.vertices.come;
  changed_vertices_ = edit.touched;
  changed_faces_ = edit.triangles.come;
  std::vector<std::uint8_t> is_changed(listed_at_.size(), 0);
  for (const std::uint32_t vertex : changed_vertices_) is_changed[vertex] = 1;
  std::size_t kept = 0;
  for (const auto& [was_vertex, was_triangle] : near_) {
    const std::uint32_t vertex = edit.vertices.now[was_vertex], triangle = edit.triangles.now[was_triangle];
    if (vertex != ListEdit::none && triangle != ListEdit::none && is_changed[vertex] == 0)
      near_[kept++] = {vertex, triangle};
  }
  near_.resize(kept);
}

void SelfCollision::forget_list() {
  listed_at_.clear();
  near_.clear();
  for (auto* changed : {&new_vertices_, &changed_vertices_, &changed_faces_}) changed->clear();
}

bool SelfCollision::may_meet(std::uint32_t vertex, std::uint32_t triangle) const {
  const Vec3 way = faces_[triangle].middle - anatomy_->surface.positions[vertex];
  const double distance = way.norm();
  if (distance < least_across * cell_) return false;
  const double out = outward_[vertex].dot(way), in = -faces_[triangle].normal.dot(way);
  const bool facing = std::min(out, in) > facing_each * distance;
  const bool far = distance > far_apart * cell_ && std::max(out, in) > -through * distance;
  return facing || far;
}

/// Returns whether vertex and triangle share nodes, so that they can't move apart. Evaluated for contact
/// candidates only, since a cut may re-embed an unchanged vertex in other nodes.
bool SelfCollision::share_nodes(std::uint32_t vertex, std::uint32_t triangle) const {
  const auto& rows = anatomy_->embedding.rows;
  ContactSide face;
  for (const std::uint32_t corner : anatomy_->surface.triangles[triangle]) face.add(rows[corner], 1);
  const auto end = face.node.begin() + static_cast<std::ptrdiff_t>(face.nodes);
  for (std::size_t k = 0; k < 4; ++k)
    if (rows[vertex].weight[k] != 0 && std::find(face.node.begin(), end, rows[vertex].node[k]) != end)
      return true;
  return false;
}

/// Sets the listed positions of new vertices as if they had moved by the mean displacement of the others.
void SelfCollision::place_new_ones(std::span<const Vec3> positions) {
  PROSECTOR_ASSERT(listed_at_.size() == positions.size());
  Vec3 shift = Vec3::Zero();
  std::size_t others = 0;
  auto come = new_vertices_.begin();
  for (std::uint32_t i = 0; i < positions.size(); ++i) {
    if (come != new_vertices_.end() && *come == i) {
      ++come;
    } else {
      shift += positions[i] - listed_at_[i];
      ++others;
    }
  }
  if (others > 0) shift /= static_cast<double>(others);
  for (const std::uint32_t vertex : new_vertices_) listed_at_[vertex] = positions[vertex] - shift;
  new_vertices_.clear();
}

double SelfCollision::neared(std::span<const Vec3> positions) const {
  PROSECTOR_ASSERT(listed_at_.size() == positions.size());
  Vec3 shift = Vec3::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i) shift += positions[i] - listed_at_[i];
  shift /= static_cast<double>(positions.size());
  double most = 0;
  for (std::size_t i = 0; i < positions.size(); ++i)
    most = std::max(most, (positions[i] - listed_at_[i] - shift).squaredNorm());
  return 2 * std::sqrt(most);
}

void SelfCollision::list(const SoftSkin& own, double reach) {
  forget_list();
  const auto positions = own.vertices->positions();
  listed_at_.assign(positions.begin(), positions.end());
  reach_ = reach;
  for (std::uint32_t vertex = 0; vertex < positions.size(); ++vertex) list_vertex(own, vertex, reach, near_);
}

void SelfCollision::list_vertex(const SoftSkin& own, std::uint32_t vertex, double reach, Pairs& out) const {
  const Vec3& x = own.vertices->positions()[vertex];
  const collision::Aabb box = collision::Aabb{x, x}.grown(reach);
  const std::size_t first = out.size();
  const collision::SurfaceTree& tree = own.faces->tree();
  tree.visit([&](const collision::Aabb& other) { return box.overlaps(other); },
             [&](const collision::SurfaceTree::Node& leaf) {
               for (std::uint32_t k = leaf.begin; k < leaf.end; ++k)
                 if (may_meet(vertex, tree.order()[k])) out.emplace_back(vertex, tree.order()[k]);
             });
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end());
}

void SelfCollision::list_changed(const SoftSkin& own, double reach) {
  std::vector<std::uint8_t> is_changed(listed_at_.size(), 0);
  Pairs fresh;
  for (const std::uint32_t vertex : changed_vertices_) {
    is_changed[vertex] = 1;
    list_vertex(own, vertex, reach, fresh);
  }
  for (const std::uint32_t triangle : changed_faces_) {
    const collision::Triangle x = own.faces->triangle(triangle);
    const Vec3 lo = x[0].cwiseMin(x[1]).cwiseMin(x[2]), hi = x[0].cwiseMax(x[1]).cwiseMax(x[2]);
    own.vertices->in_box(lo - Vec3::Constant(reach), hi + Vec3::Constant(reach), [&](std::uint32_t vertex) {
      if (is_changed[vertex] == 0 && may_meet(vertex, triangle)) fresh.emplace_back(vertex, triangle);
    });
  }
  std::sort(fresh.begin(), fresh.end());
  const auto listed = static_cast<std::ptrdiff_t>(near_.size());
  near_.insert(near_.end(), fresh.begin(), fresh.end());
  std::inplace_merge(near_.begin(), near_.begin() + listed, near_.end());
  changed_vertices_.clear();
  changed_faces_.clear();
}

/// Updates the list to contain all pairs within `reach`. Changed vertices and faces are listed from their
/// current positions. Any two points may have approached each other by neared() and may separate again, so
/// the search for them reaches that much farther.
void SelfCollision::update_list(const SoftSkin& own, double reach) {
  const auto positions = own.vertices->positions();
  const bool listed = !listed_at_.empty();
  if (listed && !new_vertices_.empty()) place_new_ones(positions);
  const double near_by = listed ? neared(positions) : 0;
  if (!listed || !(reach + near_by <= reach_))
    list(own, reach + spare * cell_);
  else if (!changed_vertices_.empty())
    list_changed(own, reach_ + near_by);
}

void SelfCollision::find(const SoftSkin& own, double margin, std::vector<VertexMeeting>& out) {
  PROSECTOR_ASSERT(own.vertices != nullptr && own.faces != nullptr);
  const auto positions = own.vertices->positions();
  margin = std::min(margin, most_margin * cell_);
  const double reach = std::max(margin, deepest_);
  update_list(own, reach);
  for (std::size_t i = 0; i < near_.size();) {
    const std::uint32_t vertex = near_[i].first;
    const Vec3 &x = positions[vertex], facing = own.vertices->outward_at(vertex);
    std::optional<VertexMeeting> nearest;
    for (; i < near_.size() && near_[i].first == vertex; ++i) {
      const std::uint32_t triangle = near_[i].second;
      const collision::Triangle corners = own.faces->triangle(triangle);
      const Vec3 weights = collision::closest_weights(x, corners[0], corners[1], corners[2]);
      const Vec3 away = x - collision::at(corners, weights);
      const double distance = away.norm();
      if (!(distance <= reach) || (nearest && distance >= std::abs(nearest->gap))) continue;
      const Vec3 outward = own.faces->normal_at(triangle, weights);
      const bool inside = away.dot(outward) < 0;
      if (distance > (inside ? deepest_ : margin)) continue;
      const Vec3 n = distance > 0 ? Vec3((inside ? -1 : 1) / distance * away) : outward;
      if (!(n.dot(outward) > least_facing_of_own && n.dot(facing) < -least_facing_of_own)) continue;
      if (share_nodes(vertex, triangle)) continue;
      nearest = {vertex, {triangle, weights}, n, inside ? -distance : distance};
    }
    if (nearest) out.push_back(*nearest);
  }
}

}  // namespace prosector::contact
