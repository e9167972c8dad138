#pragma once
// What a tetrahedron's own functions leave out first: hierarchical functions of the next order, each of an
// edge or a face. In barycentric coordinates L they are
//   of linear elements:    4·L_a·L_b of each edge: what makes them quadratic
//   of quadratic elements: L_a·L_b·(L_a − L_b) of each edge, L_a·L_b·L_c of each face: what makes them cubic
// (Zienkiewicz, Gago & Kelly 1983). Integrals of products of L over simplices are exact, so these are tables.

#include <array>
#include <cstddef>
#include <vector>

#include "common/math.h"

namespace prosector {

/// One function of a tetrahedron. Integrals are over the volume, for one of it; [c][d]: c, d are corners.
struct Bubble {
  std::vector<std::size_t> corners;  // of its edge or face, ascending
  Eigen::Matrix4d stress;            // ∫L_c·∂N/∂L_d: with a stress that is linear
  Eigen::Matrix4d stiffness;         // ∫∂N/∂L_c·∂N/∂L_d
  Eigen::Vector4d slope;             // ∫∂N/∂L_d
  Eigen::Vector4d load;              // ∫N·L_c: with a load that is linear
  double square = 0;                 // ∫N²
};

/// A function on a triangle whose corners are those of a tetrahedron's face.
struct FaceBubble {
  std::vector<std::size_t> corners;  // of its edge or the face: of 0, 1, 2, ascending
  Vec3 load;                         // ∫N·L_c over the triangle, for one of its area
};

struct BubbleTable {
  std::vector<Bubble> of_tet;
  std::vector<FaceBubble> of_face;  // those that aren't 0 there
};
BubbleTable bubbles(bool quadratic);

}  // namespace prosector
