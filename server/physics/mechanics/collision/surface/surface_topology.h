#pragma once
// Connectivity of a triangle surface, which does not change while the surface moves.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/surface/vertex_stars.h"

namespace prosector::collision {

class SurfaceTopology {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  /// Builds the connectivity of a surface with this number of vertices. Throws InputError if a triangle has
  /// an index that is not below `vertices`, or a repeated vertex.
  SurfaceTopology(std::vector<Corners> triangles, std::size_t vertices);
  /// Updates the connectivity after an edit of the surface (triangles or vertices added or removed); the
  /// result equals a rebuild. Only the edited triangles and their neighbours are recomputed, except for
  /// copying arrays and searching the connected pieces.
  void follow(const SurfaceEdit& edit);

  std::span<const Corners> triangles() const { return triangles_; }
  std::size_t vertices() const { return stars_.vertices(); }
  /// Returns the indices of the triangles that have this vertex as a corner, ascending.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return stars_[vertex]; }
  /// Returns the index of the neighbour of `triangle` across its edge from corner `edge` to corner (`edge` +
  /// 1) % 3. Returns `triangle` if the edge has no other triangle or several others.
  std::uint32_t across(std::uint32_t triangle, std::size_t edge) const { return across_[triangle][edge]; }
  /// Returns whether the surface is closed and so has an inside: each edge belongs to exactly two triangles,
  /// which traverse it in opposite directions.
  bool closed() const { return closed_; }
  /// Returns the lowest vertex index of each connected piece of the surface, ascending. Vertices without
  /// triangles are left out.
  std::span<const std::uint32_t> pieces() const { return pieces_; }

 private:
  void find_neighbours(std::uint32_t triangle);
  void find_out_whether_closed();
  void find_pieces();

  std::vector<Corners> triangles_;
  VertexStars stars_;
  std::vector<Corners> across_;
  std::vector<std::uint8_t> open_;  // per triangle: 1 if an edge violates the condition of closed()
  std::vector<std::uint32_t> pieces_;
  bool closed_ = true;
};

}  // namespace prosector::collision
