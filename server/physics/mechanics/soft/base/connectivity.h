#pragma once
// Connectivity of a body's elements of any kind: springs of 2 nodes, hinges and linear tetrahedra of 4,
// quadratic tetrahedra of 10, or a mixture.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector {

/// List of elements, each with its nodes in ascending order. The corners of element e are numbered from
/// first_corner(e), so per-corner data of all elements (forces) form one flat array. The blocks of element e,
/// one per pair of corners a < b, start at first_block(e) in the order of pair_index.
class Connectivity {
 public:
  explicit Connectivity(std::size_t nodes) : nodes_(nodes) {}
  /// Adds an element. Its nodes must be ascending and in range.
  void add(std::span<const std::uint32_t> element);
  /// Appends `elements` elements of `corners_each` corners. `nodes_of`(e): the nodes of the e-th one,
  /// ascending and in range.
  template <class NodesOf>
  void append(std::size_t elements, std::size_t corners_each, const NodesOf& nodes_of);
  void append(const Connectivity& elements);
  /// Removes all elements and sets the number of nodes.
  void clear(std::size_t nodes);
  /// Updates the connectivity after an edit of the mesh. The elements must be linear or quadratic tetrahedra,
  /// one for each tetrahedron of the mesh in the same order, each with sorted corners.
  void follow(const MeshEdit& edit);

  std::size_t nodes() const { return nodes_; }
  std::size_t size() const { return corner_begin_.size() - 1; }  // number of elements
  std::size_t corners() const { return corner_.size(); }
  std::span<const std::uint32_t> corner_nodes() const { return corner_; }  // of all elements, concatenated
  std::size_t blocks() const { return block_begin_.back(); }
  std::span<const std::uint32_t> element(std::size_t e) const {
    return std::span(corner_).subspan(corner_begin_[e], corner_begin_[e + 1] - corner_begin_[e]);
  }
  /// Returns the number of corners of each element; 0: it varies.
  std::size_t corners_each() const { return each_; }
  std::size_t first_corner(std::size_t e) const { return corner_begin_[e]; }
  std::size_t first_block(std::size_t e) const { return block_begin_[e]; }
  std::size_t element_of(std::size_t corner) const {
    if (each_ == 4) return corner / 4;  // avoids the division in the most common case
    return each_ > 0 ? corner / each_ : element_[corner];
  }

  /// Returns the index of the pair a < b in an element of n nodes: (0,1), (0,2), … (n−2,n−1).
  static constexpr std::size_t pair_index(std::size_t a, std::size_t b, std::size_t n) {
    return a * (2 * n - 3 - a) / 2 + b - 1;
  }
  static constexpr std::size_t pair_count(std::size_t n) { return n * (n - 1) / 2; }

 private:
  /// Adds elements and returns the memory to which their nodes must be written, concatenated.
  std::span<std::uint32_t> grow(std::size_t elements, std::size_t corners_each);
  void list_elements_of_corners(std::size_t first);

  std::size_t nodes_;
  std::vector<std::uint32_t> corner_;
  std::vector<std::size_t> corner_begin_{0}, block_begin_{0};
  std::size_t each_ = 0;                // corners of each element; 0: the number varies
  std::vector<std::uint32_t> element_;  // by corner, if the number varies
};

template <class NodesOf>
void Connectivity::append(std::size_t elements, std::size_t corners_each, const NodesOf& nodes_of) {
  auto to = grow(elements, corners_each).begin();
  for (std::size_t e = 0; e < elements; ++e) to = std::ranges::copy(nodes_of(e), to).out;
}

/// Corners at each node, in the order of the elements. Sums per-corner data into nodes with bitwise equal
/// results for any number of threads.
class Incidence {
 public:
  explicit Incidence(const Connectivity& elements);
  /// Updates the incidence after `elements` followed `edit`; local if the elements are the mesh's tetrahedra.
  void follow(const Connectivity& elements, const MeshEdit& edit);

  /// Returns the corners of node i, ascending.
  std::span<const std::uint32_t> corners(std::size_t node) const {
    return std::span(corner_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
  }
  /// Adds g_i += Σ f over the corners at i; `f` by corner, `g` 3n.
  void add(std::span<const Vec3> f, double* g) const;

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> corner_;
};

}  // namespace prosector
