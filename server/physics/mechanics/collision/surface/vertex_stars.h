#pragma once
// Stars of a surface's vertices: the triangles at each vertex.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/assert.h"
#include "server/physics/base/surface_edit.h"

namespace prosector {

class VertexStars {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  VertexStars(std::span<const Corners> triangles, std::size_t vertices);
  /// Updates the stars after an edit of the surface; equals a rebuild. The work is local, except for moving
  /// memory.
  void follow(const SurfaceEdit& edit);

  std::size_t vertices() const { return begin_.size() - 1; }
  /// Returns the triangles at a vertex, ascending.
  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    PROSECTOR_ASSERT(vertex < vertices());
    return {triangles_.data() + begin_[vertex], triangles_.data() + begin_[vertex + 1]};
  }
  /// Returns the triangles at these vertices without duplicates, ascending.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const;

 private:
  std::vector<std::uint32_t> begin_, triangles_;  // the triangles of vertex i start at triangles_[begin_[i]]
};

}  // namespace prosector
