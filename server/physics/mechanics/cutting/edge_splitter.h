#pragma once
// First step of a cut: splits the edges that cross the swept surface, unless an end counts as lying on the
// surface.

#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/mesh_cut.h"
#include "server/physics/mechanics/cutting/swept_surface.h"

namespace prosector::cutting {

/// Nodes that count as lying on the swept surface of a stroke, each with the plane of the surface at the
/// node, indexed by node id.
class Marks {
 public:
  using Mark = BladeStroke::Mark;
  Marks(const std::vector<Mark>& known, std::size_t nodes);
  const Mark* find(NodeId node) const { return index_[node] == none ? nullptr : &marks_[index_[node]]; }
  bool is_new(NodeId node) const { return index_[node] != none && index_[node] >= known_; }
  void add(const Mark& mark);  // the node must have no mark; it may be new
  std::span<const Mark> all() const { return marks_; }
  std::span<const Mark> added() const { return std::span(marks_).subspan(known_); }
  std::vector<Mark> by_node() const;

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<Mark> marks_;
  std::vector<std::uint32_t> index_;
  std::size_t known_;
};

/// Splits the edges of tetrahedra in `candidates` (ascending) that the swept surface `sheet` crosses. If a
/// split would create an element of bad shape, the nearer end of the edge is marked as lying on the surface
/// instead. `x`: node positions, m, by node id; grows with the new nodes. New nodes are added to `marks`, and
/// the operations to `result`.
void split_edges(TetComplex& complex, const SweptSurface& sheet, std::span<const TetId> candidates,
                 std::vector<Vec3>& x, Marks& marks, CutResult& result);

}  // namespace prosector::cutting
