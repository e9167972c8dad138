#pragma once
// Which tetrahedra may touch a box: a tree over them, refitted to where they are. A cache: answers don't
// depend on its history.

#include <span>
#include <vector>

#include "server/physics/cutting/swept_surface.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {

class TetTree {
 public:
  TetTree() = default;  // found with the first update
  explicit TetTree(const TetComplex& complex) { build(complex); }
  /// Takes in what was split since, and where what may touch the box is. `positions`: m, by node id.
  void update(const TetComplex& complex, std::span<const Vec3> positions, const Vec3& low, const Vec3& high);
  // ---- What lies in the last update's box
  /// Appends the tetrahedra of the last update whose boxes meet the piece's box and plane.
  void query(const SweptSurface::Piece& piece, std::vector<TetId>& found) const;
  /// Appends the tetrahedra of the last update whose boxes meet that box.
  void query(const Vec3& low, const Vec3& high, std::vector<TetId>& found) const;

 private:
  struct Branch {
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    std::uint32_t first = 0, last = 0;  // its leaves
    std::uint32_t right = 0;            // the left one is the next; 0: a leaf
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
  std::vector<std::uint32_t> leaf_of_;   // by tetrahedron, gone ones too
  std::vector<Vec3> low_, high_;         // of each tetrahedron, by leaf in order
  std::vector<std::size_t> leaf_begin_;  // into these
  std::vector<std::uint8_t> beside_;     // by node: on which sides of the update's box it is, a bit each
  std::vector<std::uint8_t> near_;       // by leaf: whether a tetrahedron's box meets it
  std::size_t built_tets_ = 0;
  std::uint64_t undone_ = 0;
};

}  // namespace prosector
