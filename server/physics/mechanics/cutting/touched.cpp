#include "server/physics/mechanics/cutting/touched.h"

namespace prosector::cutting {
namespace {

/// Appends the tetrahedra touched by `op`.
struct Touched {
  const TetComplex& complex;
  std::vector<TetId>& out;

  void operator()(const SplitEdge& op) const {
    for (std::uint32_t i = 0; i < op.count; ++i) {
      const TetId child = op.first + 2 * i;
      out.insert(out.end(), {complex.lineage(child).parent, child, child + 1});
    }
    if (!complex.is_sheet()) return;
    for (const NodeId end : {op.a, op.b}) {  // the ends gave mass to the new node
      const auto star = complex.star(end);
      out.insert(out.end(), star.begin(), star.end());
    }
  }
  void operator()(const SlitFaces& op) const {
    for (const auto& pair : op.faces) out.insert(out.end(), pair.begin(), pair.end());
  }
  void operator()(const PartNode& op) const {
    const auto stayed = complex.star(op.node);
    out.insert(out.end(), stayed.begin(), stayed.end());
    for (const PartNode::Copy& copy : op.copies) out.insert(out.end(), copy.tets.begin(), copy.tets.end());
  }
};

}  // namespace

std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops) {
  std::vector<TetId> met, out;
  for (const TopologyOp& op : ops) std::visit(Touched{complex, met}, op);
  // Tetrahedra usually occur many times, so flags are faster than sorting.
  std::vector<char> touched(complex.tet_end(), 0);
  for (const TetId tet : met) touched[tet] = 1;
  for (TetId tet = 0; tet < touched.size(); ++tet)
    if (touched[tet]) out.push_back(tet);
  return out;
}

}  // namespace prosector::cutting
