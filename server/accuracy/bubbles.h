#pragma once
// Hierarchical functions of the next order, which a tetrahedron's shape functions lack first. Each belongs to
// an edge or a face. In barycentric coordinates L they are
//   linear elements:    4·L_a·L_b of each edge: makes them quadratic
//   quadratic elements: L_a·L_b·(L_a − L_b) of each edge, L_a·L_b·L_c of each face: makes them cubic
// (Zienkiewicz, Gago & Kelly 1983). Integrals of products of L over simplices are exact, so these are tables.

#include <array>
#include <cstddef>
#include <vector>

#include "common/math.h"

namespace prosector {

/// A hierarchical function N of the next order on a tetrahedron, given by its integrals over the volume, per
/// unit of volume. Matrix indices [c][d] are corners of the tetrahedron.
struct Bubble {
  std::vector<std::size_t> corners;  // of its edge or face, ascending
  Eigen::Matrix4d stress;            // ∫L_c·∂N/∂L_d: for a linear stress
  Eigen::Matrix4d stiffness;         // ∫∂N/∂L_c·∂N/∂L_d
  Eigen::Vector4d slope;             // ∫∂N/∂L_d
  Eigen::Vector4d load;              // ∫N·L_c: for a linear load
  double square = 0;                 // ∫N²
};

/// A hierarchical function N of the next order on a triangle. The triangle's corners are those of a
/// tetrahedron's face.
struct FaceBubble {
  std::vector<std::size_t> corners;  // of its edge or the face: among 0, 1, 2, ascending
  Vec3 load;                         // ∫N·L_c over the triangle, per unit of area
};

struct BubbleTable {
  std::vector<Bubble> of_tet;
  std::vector<FaceBubble> of_face;  // those that aren't 0 on the face
};
BubbleTable bubbles(bool quadratic);

}  // namespace prosector
