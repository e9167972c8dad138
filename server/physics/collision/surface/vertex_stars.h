#pragma once
// The triangles around each vertex of a surface: its star.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/surface_edit.h"

namespace prosector {

class VertexStars {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  VertexStars(std::span<const Corners> triangles, std::size_t vertices);
  /// Follows a change to the stars of the surface after it: local but for moving memory.
  void follow(const SurfaceEdit& edit);

  std::size_t vertices() const { return begin_.size() - 1; }
  /// Returns the triangles at a vertex, ascending.
  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    return {triangles_.data() + begin_[vertex], triangles_.data() + begin_[vertex + 1]};
  }
  /// Returns the triangles at these vertices, each once; ascending.
  std::vector<std::uint32_t> around(std::span<const std::uint32_t> vertices) const;

 private:
  std::vector<std::uint32_t> begin_, triangles_;  // of vertex i: triangles_ from begin_[i] on
};

}  // namespace prosector
