#pragma once
// Connectivity of a body's elements of any kind: springs of 2 nodes, hinges and linear tetrahedra of 4,
// quadratic tetrahedra of 10, or a mixture.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "common/math.h"
#include "server/physics/mechanics/soft/base/mesh_edit.h"

namespace prosector::soft {

/// List of a body's elements, each with its nodes in ascending order. The corners of element e are numbered
/// from first_corner(e) on, so that data per corner (forces) of all elements form one array. Each element has
/// one stiffness block per pair of corners a < b. They start at index first_block(e), in the order of
/// pair_index.
class Connectivity {
 public:
  explicit Connectivity(std::size_t nodes) : nodes_(nodes) {}
  /// Appends an element with these nodes, which must be in ascending order and less than the number of nodes.
  void add(std::span<const std::uint32_t> element);
  /// Appends a number of `elements` with `corners_each` corners each. `nodes_of`(e) must return the nodes of
  /// the e-th of them, ascending and less than the number of nodes.
  template <class NodesOf>
  void append(std::size_t elements, std::size_t corners_each, const NodesOf& nodes_of);
  void append(const Connectivity& elements);
  /// Removes all elements and sets the number of the body's nodes to `nodes`.
  void clear(std::size_t nodes);
  /// Updates the elements after `edit` changed the mesh. They must be linear or quadratic tetrahedra, one for
  /// each tetrahedron of the mesh in the same order, each with sorted corners.
  void follow(const MeshEdit& edit);

  std::size_t nodes() const { return nodes_; }
  std::size_t size() const { return corner_begin_.size() - 1; }  // number of elements
  std::size_t corners() const { return corner_.size(); }
  std::span<const std::uint32_t> corner_nodes() const { return corner_; }  // of all elements, concatenated
  std::size_t blocks() const { return block_begin_.back(); }
  std::span<const std::uint32_t> element(std::size_t e) const {
    return std::span(corner_).subspan(corner_begin_[e], corner_begin_[e + 1] - corner_begin_[e]);
  }
  /// Returns the number of corners that each element has; 0 if elements have different numbers of corners.
  std::size_t corners_each() const { return each_; }
  std::size_t first_corner(std::size_t e) const { return corner_begin_[e]; }
  std::size_t first_block(std::size_t e) const { return block_begin_[e]; }
  std::size_t element_of(std::size_t corner) const {
    if (each_ == 4) return corner / 4;  // avoids the division in the most common case
    return each_ > 0 ? corner / each_ : element_[corner];
  }

  /// Returns the index of the pair of corners a < b of an element with n corners in the order (0,1), (0,2),
  /// …, (n−2,n−1), which is the order of its stiffness blocks.
  static constexpr std::size_t pair_index(std::size_t a, std::size_t b, std::size_t n) {
    return a * (2 * n - 3 - a) / 2 + b - 1;
  }
  static constexpr std::size_t pair_count(std::size_t n) { return n * (n - 1) / 2; }

 private:
  /// Appends a number of `elements` with `corners_each` corners each. Returns the memory into which the
  /// caller must write their nodes, element by element.
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

/// For each node, the list of element corners at that node, in the order of the elements. Used to sum data
/// per corner into nodes with bitwise equal results for any number of threads.
class Incidence {
 public:
  explicit Incidence(const Connectivity& elements);
  /// Updates the lists of corners at nodes after `elements` were updated for the mesh edit `edit`. Only lists
  /// near the edit are recomputed if the elements are the mesh's tetrahedra.
  void follow(const Connectivity& elements, const MeshEdit& edit);

  /// Returns the element corners at this node, as ascending indices among all corners of the body's elements.
  std::span<const std::uint32_t> corners(std::size_t node) const {
    return std::span(corner_).subspan(begin_[node], begin_[node + 1] - begin_[node]);
  }
  /// Adds forces at element corners to nodes: g_i += Σ f over the corners at node i. `f`: one vector per
  /// corner; `g`: 3 values per node.
  void add(std::span<const Vec3> f, double* g) const;

 private:
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> corner_;
};

}  // namespace prosector::soft
