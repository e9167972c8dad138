#pragma once
// Winding numbers of surfaces.

#include <cstdint>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Generalised winding numbers of a surface (Jacobson et al. 2013), accelerated by a tree whose far nodes are
/// approximated by one dipole each (Barill et al. 2018). For a closed, outward-facing surface the winding
/// number is 1 inside and 0 outside; those of nested and overlapping shells add up. They are within about
/// 0.03 of the exact sum of solid angles.
class WindingTree {
 public:
  explicit WindingTree(const TriangleMesh& surface);
  double at(const Vec3& x) const;

 private:
  struct Node {
    Vec3 center = Vec3::Zero();      // area-weighted centre of its triangles
    Vec3 area = Vec3::Zero();        // sum of its triangles' area vectors
    double radius = 0;               // of a ball around the centre that contains its triangles
    std::size_t begin = 0, end = 0;  // range of its triangles in corners_
    std::uint32_t right = 0;         // index of the second child; the first is the next node; 0: a leaf
  };
  struct Corners {
    Vec3 a, b, c;
    Vec3 middle() const { return (a + b + c) / 3; }
  };
  std::uint32_t grow(std::size_t begin, std::size_t end);

  std::vector<Corners> corners_;
  std::vector<Node> nodes_;
};

}  // namespace prosector
