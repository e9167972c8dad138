#include "server/physics/mechanics/contact/element_surface.h"

#include <algorithm>
#include <utility>

#include "common/assert.h"

namespace prosector::contact {
namespace {

std::vector<collision::SurfaceTree::Corners> elements_of(const Anatomy& anatomy) {
  std::vector<collision::SurfaceTree::Corners> out;
  for (const auto& [a, b] : anatomy.segments) out.push_back({a, b, b});
  for (const auto& [a, b, c, d] : anatomy.quads) {
    out.push_back({a, b, c});
    out.push_back({a, c, d});
  }
  for (const auto& triangle : anatomy.triangles) out.push_back(triangle);
  return out;
}

}  // namespace

ElementSurface::ElementSurface(const Anatomy& anatomy)
    : elements_(elements_of(anatomy)),
      rest_(anatomy.tets.positions),
      positions_(rest_),
      tree_(elements_, rest_) {
  find_edges();
  find_neighbours();
}

void ElementSurface::find_edges() {
  for (const collision::SurfaceTree::Corners& c : elements_)
    for (std::size_t k = 0; k < 3; ++k)
      if (const auto [a, b] = std::minmax(c[k], c[(k + 1) % 3]); a != b) edges_.push_back({a, b});
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
}

void ElementSurface::find_neighbours() {
  std::vector<std::vector<std::uint32_t>> with_corner(rest_.size());
  for (std::uint32_t e = 0; e < elements_.size(); ++e)
    for (const std::uint32_t corner : elements_[e]) with_corner[corner].push_back(e);
  around_begin_.push_back(0);
  std::vector<std::uint32_t> seen_by(elements_.size(), ~0U);
  for (std::uint32_t e = 0; e < elements_.size(); ++e) {
    for (const std::uint32_t corner : elements_[e])
      for (const std::uint32_t other : with_corner[corner])
        if (std::exchange(seen_by[other], e) != e) around_.push_back(other);
    std::sort(around_.begin() + around_begin_.back(), around_.end());
    around_begin_.push_back(static_cast<std::uint32_t>(around_.size()));
  }
}

bool ElementSurface::hang_together(std::uint32_t element, std::uint32_t other, double reach) const {
  PROSECTOR_ASSERT(element < elements_.size() && other < elements_.size() && reach > 0);
  if (together_.empty() || reach != reach_) together_.assign(elements_.size(), {});
  reach_ = reach;
  std::vector<std::uint32_t>& met = together_[element];
  if (met.empty()) {
    const collision::Triangle own = at_rest(element);
    std::vector<std::uint32_t> seen = {element};  // ascending
    met.push_back(element);
    for (std::size_t n = 0; n < met.size(); ++n)
      for (const std::uint32_t next : around(met[n])) {
        const auto place = std::lower_bound(seen.begin(), seen.end(), next);
        if (place != seen.end() && *place == next) continue;
        seen.insert(place, next);
        if (collision::closest(own, at_rest(next)).squared_distance < reach * reach) met.push_back(next);
      }
    std::sort(met.begin(), met.end());
  }
  return std::binary_search(met.begin(), met.end(), other);
}

void ElementSurface::move(const VecX& x) {
  PROSECTOR_ASSERT(x.size() == 3 * std::ssize(positions_));
  for (std::size_t i = 0; i < positions_.size(); ++i)
    positions_[i] = x.segment<3>(3 * static_cast<Eigen::Index>(i));
  tree_.refit(elements_, positions_);
}

ElementSurface::Support ElementSurface::support(std::uint32_t element, const Vec3& weights) const {
  Support out;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t node = elements_[element][k];
    const bool seen = out.count > 0 && out.node[out.count - 1] == node;  // repeated corner of a segment
    if (weights[static_cast<Eigen::Index>(k)] != 0 && !seen) out.node[out.count++] = node;
  }
  return out;
}

std::uint32_t ElementSurface::feature(std::uint32_t element, const Vec3& weights) const {
  const Support on = support(element, weights);
  if (on.count == 1) return on.node[0];
  const auto corners = static_cast<std::uint32_t>(rest_.size());
  if (on.count == 3) return corners + static_cast<std::uint32_t>(edges_.size()) + element;
  const auto edge =
      std::lower_bound(edges_.begin(), edges_.end(),
                       std::array{std::min(on.node[0], on.node[1]), std::max(on.node[0], on.node[1])});
  PROSECTOR_ASSERT(edge != edges_.end());
  return corners + static_cast<std::uint32_t>(edge - edges_.begin());
}

bool ElementSurface::crest_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const {
  const Support on = support(element, weights);
  if (on.count == 3) return true;
  const Vec3& from = positions_[on.node[0]];
  const Vec3 along = on.count == 2 ? Vec3((positions_[on.node[1]] - from).normalized()) : Vec3(Vec3::Zero());
  for (const std::uint32_t e : around(element)) {
    if (!on.within(elements_[e])) continue;
    for (const std::uint32_t node : elements_[e]) {
      if (on.has(node)) continue;
      Vec3 way = positions_[node] - from;
      way -= along.dot(way) * along;
      if (n.dot(way) > slack * way.norm()) return false;
    }
  }
  return true;
}

Vec3 ElementSurface::doubled_area(std::uint32_t element) const {
  const collision::Triangle t = now(element);
  return (t[1] - t[0]).cross(t[2] - t[0]);
}

bool ElementSurface::level_at(std::uint32_t element, const Vec3& weights, const Vec3& n, double slack) const {
  const Support on = support(element, weights);
  const auto near = around(element);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t e) {
    if (!on.within(elements_[e])) return false;
    const Vec3 face = doubled_area(e);
    return face.cross(n).norm() < slack * face.norm();
  });
}

Vec3 ElementSurface::normal_at(std::uint32_t element, const Vec3& weights, const Vec3& n) const {
  const Support on = support(element, weights);
  Vec3 sum = Vec3::Zero();
  for (const std::uint32_t e : around(element)) {
    if (!on.within(elements_[e])) continue;
    const Vec3 face = doubled_area(e);
    sum += face.dot(n) < 0 ? Vec3(-face) : face;
  }
  return sum.normalized();
}

void ElementSurface::add(std::uint32_t element, const Vec3& weights, ContactSide& side) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t node = elements_[element][k];
    if (const double w = weights[static_cast<Eigen::Index>(k)]; w != 0)
      side.add({{node, node, node, node}, {1, 0, 0, 0}}, w);
  }
}

}  // namespace prosector::contact
