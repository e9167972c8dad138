#pragma once
// How a surface's triangles hang together: what doesn't change while it moves.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/collision/surface/vertex_stars.h"

namespace prosector {

class SurfaceTopology {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  /// Throws InputError when a triangle names a vertex that isn't there or one vertex twice.
  SurfaceTopology(std::vector<Corners> triangles, std::size_t vertices);
  /// Follows a change to the topology of the surface after it: local but for moving memory and the search for
  /// pieces.
  void follow(const SurfaceEdit& edit);

  std::span<const Corners> triangles() const { return triangles_; }
  std::size_t vertices() const { return stars_.vertices(); }
  /// Returns the triangles around a vertex, ascending.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return stars_[vertex]; }
  /// Returns the triangle across edge (k, k + 1); itself where there is none or more than one.
  std::uint32_t across(std::uint32_t triangle, std::size_t edge) const { return across_[triangle][edge]; }
  /// Tells whether every edge has two triangles that agree: the surface has an inside.
  bool closed() const { return closed_; }
  /// Returns a vertex of each connected piece, ascending.
  std::span<const std::uint32_t> pieces() const { return pieces_; }

 private:
  void find_neighbours(std::uint32_t triangle);
  void find_out_whether_closed();
  void find_pieces();

  std::vector<Corners> triangles_;
  VertexStars stars_;
  std::vector<Corners> across_;
  std::vector<std::uint8_t> open_;  // by triangle: an edge of it has not two triangles that agree
  std::vector<std::uint32_t> pieces_;
  bool closed_ = true;
};

}  // namespace prosector
