#include "server/physics/mechanics/collision/surface/vertex_stars.h"

#include <algorithm>
#include <numeric>

#include "common/assert.h"

namespace prosector::collision {

VertexStars::VertexStars(std::span<const Corners> triangles, std::size_t vertices) : begin_(vertices + 1, 0) {
  for (const Corners& t : triangles)
    for (const std::uint32_t corner : t) ++begin_[corner + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  triangles_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t corner : triangles[i]) triangles_[next[corner]++] = i;
}

void VertexStars::follow(const SurfaceEdit& edit) {
  PROSECTOR_ASSERT(edit.corners.size() == edit.triangles.come.size() &&
                   edit.vertices.now.size() == vertices());
  struct Coming {
    std::uint32_t vertex, triangle;
    auto operator<=>(const Coming&) const = default;
  };
  std::vector<Coming> come;
  come.reserve(3 * edit.corners.size());
  for (std::size_t i = 0; i < edit.corners.size(); ++i)
    for (const std::uint32_t corner : edit.corners[i]) come.push_back({corner, edit.triangles.come[i]});
  std::sort(come.begin(), come.end());
  std::vector<std::uint32_t> begin(edit.vertices.size() + 1, 0), stars;
  stars.reserve(triangles_.size() + come.size());
  const std::span<const std::uint32_t> now = edit.triangles.now;
  auto new_vertex = edit.vertices.come.begin();
  auto coming = come.begin();
  for (std::uint32_t vertex = 0, before = 0; vertex < edit.vertices.size(); ++vertex) {
    if (new_vertex != edit.vertices.come.end() && *new_vertex == vertex) {
      ++new_vertex;
    } else {
      while (edit.vertices.now[before] == ListEdit::none) ++before;
      for (const std::uint32_t triangle : (*this)[before++])
        if (now[triangle] != ListEdit::none) stars.push_back(now[triangle]);
    }
    const auto middle = static_cast<std::ptrdiff_t>(stars.size());
    for (; coming != come.end() && coming->vertex == vertex; ++coming) stars.push_back(coming->triangle);
    if (middle != static_cast<std::ptrdiff_t>(stars.size()))
      std::inplace_merge(stars.begin() + begin[vertex], stars.begin() + middle, stars.end());
    begin[vertex + 1] = static_cast<std::uint32_t>(stars.size());
  }
  PROSECTOR_ASSERT(coming == come.end() && begin.back() == stars.size());
  begin_ = std::move(begin);
  triangles_ = std::move(stars);
}

std::vector<std::uint32_t> VertexStars::around(std::span<const std::uint32_t> vertices) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t vertex : vertices) {
    const auto star = (*this)[vertex];
    out.insert(out.end(), star.begin(), star.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace prosector::collision
