#pragma once
// Stars of a surface's vertices: the triangles at each vertex.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/assert.h"
#include "server/physics/base/surface_edit.h"

namespace prosector::collision {

class VertexStars {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  VertexStars(std::span<const Corners> triangles, std::size_t vertices);
  /// Updates the lists of triangles at each vertex after an edit of the surface; the result equals a rebuild.
  /// Only the edited lists are recomputed; the others are copied.
  void follow(const SurfaceEdit& edit);

  std::size_t vertices() const { return begin_.size() - 1; }
  /// Returns the indices of the triangles that have this vertex as a corner, ascending.
  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    PROSECTOR_ASSERT(vertex < vertices());
    return {triangles_.data() + begin_[vertex], triangles_.data() + begin_[vertex + 1]};
  }
  /// Returns the indices of the triangles that have any of these vertices as a corner, ascending and without
  /// duplicates.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const;

 private:
  std::vector<std::uint32_t> begin_, triangles_;  // the triangles of vertex i start at triangles_[begin_[i]]
};

}  // namespace prosector::collision
