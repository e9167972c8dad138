#pragma once
// Matrices of rotated elements in single precision, without storing element blocks: row by row, each block is
// summed over the elements that share its two nodes.

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/matrices/symmetric_rows.h"

namespace prosector::soft {

/// Input of the assembly kernel for rotated elements: the matrix patterns, which give rows and incident
/// elements, and the elements' data.
struct CorotatedRows {
  const BlockPattern& blocks;
  const SymmetricPattern& pattern;
  const CorotatedElements& elements;
};

class CorotatedStiffness {
 public:
  /// Prepares for matrices of these elements, which must have 4 corners and one integration point each, or 10
  /// corners and four points. All arguments must outlive this object.
  CorotatedStiffness(const Connectivity& elements, const BlockPattern& blocks,
                     const SymmetricPattern& pattern);

  /// Resizes the arrays after the body's elements changed.
  void fit();

  /// Assembles the stiffness matrix K of the corotational law from rotated elements, including their twists
  /// (the rotational part of the tangent). Each row is summed separately, in the order of its elements, so
  /// results are bitwise equal for any number of threads.
  void assemble(const CorotatedElements& elements, SymmetricRows& K) const;

  // ---- K, the warped stiffness (independent of the twists), element by element, in double precision except
  // for the gradients; exactly zero for translations. 3n vectors.
  /// Returns ½uᵀKu, J, for node displacements u (3n, m), where K is the warped stiffness: the linear elastic
  /// stiffness, rotated with each element.
  double energy(const CorotatedElements& elements, const double* u);
  /// Returns ½uᵀKu, J, for node displacements u (3n, m), and computes the forces f = K·u (3n, N). K is the
  /// warped stiffness: the linear elastic stiffness, rotated with each element.
  double multiply(const CorotatedElements& elements, const double* u, double* f);

 private:
  double visit(const CorotatedElements& elements, const double* u, Vec3* forces);
  std::size_t corners() const { return connectivity_.element(0).size(); }

  const Connectivity& connectivity_;
  const BlockPattern& blocks_;
  const SymmetricPattern& pattern_;
  std::vector<Vec3> forces_;   // by corner
  std::vector<double> moved_;  // u, four numbers per node
  std::vector<double> sums_;   // one per chunk
};

}  // namespace prosector::soft
