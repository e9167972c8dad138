#include "server/physics/mechanics/cutting/cut_through.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::cutting {
namespace {

bool is_marked_face(const TetComplex& complex, const Marks& marks, TetId tet, std::size_t k) {
  const auto corners = complex.corners(tet);
  return std::ranges::all_of(TetComplex::face[k], [&](std::size_t j) {
    return j >= corners.size() || marks.find(corners[j]) != nullptr;
  });
}

/// Parts of the body: tetrahedra connected through faces that are not fully marked.
class Parts {
 public:
  Parts(const TetComplex& complex, const Marks& marks, double least_fragment)
      : complex_(complex), marks_(marks), least_fragment_(least_fragment), of_(complex.tet_end(), none) {
    for (const TetId t : tet_ids(complex))
      if (of_[t] == none) fill(t);
  }
  /// Joins fragments that are too small to be a part to an adjacent part.
  void join_crumbs() {
    std::vector<TetId> left;
    for (const TetId t : tet_ids(complex_))
      if (!is_part_[of_[t]]) left.push_back(t);
    for (bool any = true; any;) {
      any = false;
      for (const TetId t : left)
        for (std::size_t k = 0; k < complex_.sides() && !is_part_[of_[t]]; ++k)
          if (const TetId beyond = complex_.neighbor(t, k);
              beyond != TetComplex::none && is_part_[of_[beyond]]) {
            of_[t] = of_[beyond];
            any = true;
          }
    }
  }
  /// Returns whether two tetrahedra belong to different parts. A fragment without an adjacent part belongs to
  /// no part.
  bool differ(TetId a, TetId b) const { return of_[a] != of_[b] && is_part_[of_[a]] && is_part_[of_[b]]; }

 private:
  static constexpr std::uint32_t none = UINT32_MAX;
  void fill(TetId first) {
    PROSECTOR_ASSERT(complex_.has_tet(first) && of_[first] == none);
    const auto part = static_cast<std::uint32_t>(is_part_.size());
    double volume = 0;
    bool is_inside = false;  // has an unmarked node
    std::vector<TetId> open = {first};
    of_[first] = part;
    while (!open.empty()) {
      const TetId t = open.back();
      open.pop_back();
      volume += complex_.volume(t);
      for (const NodeId corner : complex_.corners(t)) is_inside |= marks_.find(corner) == nullptr;
      for (std::size_t k = 0; k < complex_.sides(); ++k) {
        const TetId beyond = complex_.neighbor(t, k);
        if (beyond == TetComplex::none || of_[beyond] != none || is_marked_face(complex_, marks_, t, k))
          continue;
        of_[beyond] = part;
        open.push_back(beyond);
      }
    }
    is_part_.push_back(is_inside && volume > least_fragment_);
  }
  const TetComplex& complex_;
  const Marks& marks_;
  double least_fragment_;
  std::vector<std::uint32_t> of_;
  std::vector<bool> is_part_;
};

}  // namespace

BladeStroke::Mark mark_between(const TetComplex& complex, const Marks& marks, NodeId node) {
  PROSECTOR_ASSERT(complex.has_node(node) && !marks.find(node));
  BladeStroke::Mark out{node, complex.rest(node), Vec3::Zero()};
  for (const TetId t : complex.star(node))
    for (const NodeId corner : complex.corners(t))
      if (const BladeStroke::Mark* mark = marks.find(corner)) out.normal += mark->normal;
  const double length = out.normal.norm();
  out.normal = length > 0 ? Vec3(out.normal / length) : Vec3::UnitX();
  return out;
}

SlitFaces faces_between_parts(const TetComplex& complex, const Marks& marks, double least_fragment) {
  PROSECTOR_ASSERT(least_fragment >= 0);
  SlitFaces op;
  for (const BladeStroke::Mark& mark : marks.all()) {
    if (!complex.has_node(mark.node)) continue;
    for (const TetId t : complex.star(mark.node))
      for (std::size_t k = 0; k < complex.sides(); ++k)
        if (const TetId beyond = complex.neighbor(t, k); beyond != TetComplex::none && t < beyond)
          if (is_marked_face(complex, marks, t, k)) op.faces.push_back({t, beyond});
  }
  if (op.faces.empty()) return op;
  std::sort(op.faces.begin(), op.faces.end());
  op.faces.erase(std::unique(op.faces.begin(), op.faces.end()), op.faces.end());
  Parts parts(complex, marks, least_fragment);
  parts.join_crumbs();
  std::erase_if(op.faces, [&](const std::array<TetId, 2>& f) { return !parts.differ(f[0], f[1]); });
  return op;
}

}  // namespace prosector::cutting
