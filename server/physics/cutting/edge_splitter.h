#pragma once
// The first half of a cut: no edge is left that crosses the sheet away from a node that counts as on it.

#include <span>
#include <vector>

#include "server/physics/cutting/mesh_cut.h"
#include "server/physics/cutting/swept_surface.h"

namespace prosector {

/// The nodes that count as lying on the blade, by node id.
class Marks {
 public:
  using Mark = BladeStroke::Mark;
  Marks(const std::vector<Mark>& known, std::size_t nodes);
  const Mark* find(NodeId node) const { return index_[node] == none ? nullptr : &marks_[index_[node]]; }
  bool is_new(NodeId node) const { return index_[node] != none && index_[node] >= known_; }
  void add(const Mark& mark);  // of a node that has none; may be new
  std::span<const Mark> all() const { return marks_; }
  std::span<const Mark> added() const { return std::span(marks_).subspan(known_); }
  std::vector<Mark> by_node() const;

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  std::vector<Mark> marks_;
  std::vector<std::uint32_t> index_;
  std::size_t known_;
};

/// Splits what `sheet` crosses among `candidates` (ascending). `x`: m, by node id; grows with new nodes.
void split_edges(TetComplex& complex, const SweptSurface& sheet, std::span<const TetId> candidates,
                 std::vector<Vec3>& x, Marks& marks, CutResult& result);

}  // namespace prosector
