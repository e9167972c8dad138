#pragma once
// Connectivity of a triangle surface, which does not change while the surface moves.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "server/physics/mechanics/collision/surface/vertex_stars.h"

namespace prosector {

class SurfaceTopology {
 public:
  using Corners = std::array<std::uint32_t, 3>;
  /// Throws InputError if a triangle has an unknown vertex index or a repeated vertex.
  SurfaceTopology(std::vector<Corners> triangles, std::size_t vertices);
  /// Updates the topology after an edit of the surface; equals a rebuild. The work is local, except for
  /// moving memory and the search for connected pieces.
  void follow(const SurfaceEdit& edit);

  std::span<const Corners> triangles() const { return triangles_; }
  std::size_t vertices() const { return stars_.vertices(); }
  /// Returns the triangles at a vertex, ascending.
  std::span<const std::uint32_t> around(std::uint32_t vertex) const { return stars_[vertex]; }
  /// Returns the triangle across edge (k, k + 1); the triangle itself if the edge has no or several other
  /// triangles.
  std::uint32_t across(std::uint32_t triangle, std::size_t edge) const { return across_[triangle][edge]; }
  /// Returns whether each edge has exactly two triangles of consistent orientation, so that the surface has
  /// an inside.
  bool closed() const { return closed_; }
  /// Returns one vertex of each connected piece, ascending.
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

}  // namespace prosector
