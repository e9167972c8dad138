#pragma once
// Bounding volume tree over the tetrahedra, refitted to current positions, to find those that may overlap a
// box. The tree is a cache: query results do not depend on its history.

#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/swept_surface.h"
#include "server/physics/mechanics/cutting/tet_complex.h"

namespace prosector::cutting {

class TetTree {
 public:
  TetTree() = default;  // built by the first update
  explicit TetTree(const TetComplex& complex) { build(complex); }
  /// Adds the tetrahedra created by splits since the last update. Refits the boxes of tetrahedra that may
  /// overlap the box low–high (m, world frame) to `positions` (m, by node id). Later queries must be within
  /// that box.
  void update(const TetComplex& complex, std::span<const Vec3> positions, const Vec3& low, const Vec3& high);
  // ---- Queries within the box of the last update
  /// Appends the ids of tetrahedra whose bounding boxes, as of the last update, overlap the bounding box of
  /// this triangle of a swept surface and intersect its plane.
  void query(const SweptSurface::Piece& piece, std::vector<TetId>& found) const;
  /// Appends the ids of tetrahedra whose bounding boxes, as of the last update, overlap the box low–high (m,
  /// world frame).
  void query(const Vec3& low, const Vec3& high, std::vector<TetId>& found) const;

 private:
  struct Branch {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    std::uint32_t first = 0, last = 0;  // range of its leaves
    std::uint32_t right = 0;            // right child, the left one is the next branch; 0: a leaf
  };
  void build(const TetComplex& complex);
  std::uint32_t split(std::span<const TetId> tets, std::size_t begin, std::size_t end);
  void take_in(const TetComplex& complex);
  template <class Meets>
  void visit(Meets&& meets, std::vector<TetId>& found) const;
  void find_near(const TetComplex& complex, std::span<const Vec3> positions, const Vec3& low,
                 const Vec3& high);
  void boxes(const TetComplex& complex, std::span<const Vec3> positions);

  std::vector<Branch> branches_;  // parents before children
  std::vector<std::vector<TetId>> leaves_;
  std::vector<std::uint32_t> leaf_of_;   // by tetrahedron, including removed ones
  std::vector<Vec3> low_, high_;         // of each tetrahedron, in the order of leaves
  std::vector<std::size_t> leaf_begin_;  // by leaf: start in low_ and high_
  std::vector<std::uint8_t> beside_;     // by node: outcode, one bit per side of the update's box
  std::vector<std::uint8_t> near_;       // by leaf: whether a tetrahedron may overlap the update's box
  std::size_t built_tets_ = 0;
  std::uint64_t undone_ = 0;
};

}  // namespace prosector::cutting
