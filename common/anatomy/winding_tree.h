#pragma once
// How often a surface winds around a point.

#include <cstdint>
#include <vector>

#include "common/mesh.h"

namespace prosector {

/// Generalised winding numbers of a surface (Jacobson et al. 2013), fast by a tree whose far branches count
/// as one dipole each (Barill et al. 2018). Of a closed surface that faces outward it is 1 inside and 0
/// outside; shells within shells and overlaps add up. Within about 0.03 of the exact sum of solid angles.
class WindingTree {
 public:
  explicit WindingTree(const TriangleMesh& surface);
  double at(const Vec3& x) const;

 private:
  struct Node {
    Vec3 center = Vec3::Zero();      // of its triangles, by area
    Vec3 area = Vec3::Zero();        // sum of their area vectors
    double radius = 0;               // of a ball around the centre that holds them
    std::size_t begin = 0, end = 0;  // of its triangles, in corners_
    std::uint32_t right = 0;         // its second child; the first is the next node; 0: a leaf
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
