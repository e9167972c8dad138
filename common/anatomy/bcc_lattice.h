#pragma once
// Body-centred cubic (BCC) lattice around a solid: two interlaced cubic grids. Its tetrahedra are congruent:
// two opposite long edges (the lattice constant a) and four short ones (√3/2 a).

#include <array>
#include <cstddef>
#include <cstdint>

#include "common/anatomy/field.h"

namespace prosector {

/// Returns the number of points of a body-centred cubic lattice with the short edge `cell` (m) that covers a
/// box with sides `extent` (m).
double lattice_points(const Vec3& extent, double cell);

/// Throws InputError unless `cell` and the sides of the field's box are positive and finite.
void require_sizes(const SolidField& field, double cell);

class BccLattice {
 public:
  /// Defines a lattice that covers field.box with a margin. `cell` (m) is the short edge between adjacent
  /// points; `offset` shifts the lattice, in lattice constants. Allocates nothing. Throws InputError if
  /// `cell` isn't positive, or if more than `max_points` would be needed; the message then states the finest
  /// allowed cell.
  BccLattice(const SolidField& field, double cell, const Vec3& offset, double max_points);

  std::size_t size() const { return 2 * grid_; }
  Vec3 position(std::size_t point) const;
  double edge_length(bool is_long) const { return is_long ? a_ : 0.86602540378443865 * a_; }
  /// Returns whether the edge between two adjacent lattice points (by index) is a long one. Long edges
  /// connect points of the same of the two cubic grids that form the lattice.
  bool is_long(std::size_t a, std::size_t b) const { return (a < grid_) == (b < grid_); }
  /// Returns whether an even number of coordinates increases from lattice point p to its neighbour n along a
  /// short edge.
  bool parity(std::size_t p, std::size_t n) const;

  /// Calls visit(neighbour, is_long) for each neighbour of a lattice point, in a fixed order. `neighbour` is
  /// its index; `is_long` states whether the edge to it is one of the lattice's long edges.
  template <class Visit>
  void for_neighbors(std::size_t point, Visit&& visit) const {
    const bool center = point >= grid_;
    const Index i = index(point);
    for (int k = 0; k < 3; ++k)
      for (int d = -1; d <= 1; d += 2) {
        Index j = i;
        j[static_cast<std::size_t>(k)] += d;
        if (inside(j)) visit(number(j, center), true);
      }
    for (int corner = 0; corner < 8; ++corner) {
      Index j = i;
      for (std::size_t k = 0; k < 3; ++k) j[k] += ((corner >> k) & 1) - (center ? 0 : 1);
      if (inside(j)) visit(number(j, !center), false);
    }
  }

  /// Calls visit({c, c', v, v'}) for each tetrahedron of the lattice, with the indices of its points. Points
  /// c and c' are the centres of two cubic cells that share a face. Points v and v' are the ends of an edge
  /// of that face.
  template <class Visit>
  void for_tets(Visit&& visit) const {
    Index i;
    for (i[2] = 0; i[2] < n_[2]; ++i[2])
      for (i[1] = 0; i[1] < n_[1]; ++i[1])
        for (i[0] = 0; i[0] < n_[0]; ++i[0])
          for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            Index next = i;
            ++next[axis];
            Index ring = next;  // corners of the shared face, in order around it
            if (next[axis] >= n_[axis] || i[u] + 1 >= n_[u] || i[v] + 1 >= n_[v]) continue;
            std::array<std::size_t, 4> corner{};
            for (std::size_t k = 0; k < 4; ++k) {
              ring[u] = i[u] + (k == 1 || k == 2 ? 1 : 0);
              ring[v] = i[v] + (k >= 2 ? 1 : 0);
              corner[k] = number(ring, false);
            }
            for (std::size_t k = 0; k < 4; ++k)
              visit(std::array<std::size_t, 4>{number(i, true), number(next, true), corner[k],
                                               corner[(k + 1) % 4]});
          }
  }

 private:
  using Index = std::array<int, 3>;

  bool inside(const Index& i) const {
    return i[0] >= 0 && i[1] >= 0 && i[2] >= 0 && i[0] < n_[0] && i[1] < n_[1] && i[2] < n_[2];
  }
  std::size_t number(const Index& i, bool center) const {
    return (center ? grid_ : 0) + static_cast<std::size_t>(i[0]) +
           static_cast<std::size_t>(n_[0]) *
               (static_cast<std::size_t>(i[1]) +
                static_cast<std::size_t>(n_[1]) * static_cast<std::size_t>(i[2]));
  }
  Index index(std::size_t point) const;

  double a_ = 0;  // lattice constant, m
  Vec3 origin_ = Vec3::Zero();
  Index n_{};             // points of each grid along each axis
  std::size_t grid_ = 0;  // points of one grid; centres are numbered after the corners
};

}  // namespace prosector
