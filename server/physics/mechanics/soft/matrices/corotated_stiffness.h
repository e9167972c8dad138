#pragma once
// Matrices of rotated elements in single precision, without storing element blocks: row by row, each block is
// summed over the elements that share its two nodes.

#include "server/physics/mechanics/soft/elements/corotated_elements.h"
#include "server/physics/mechanics/soft/matrices/symmetric_rows.h"

namespace prosector {

/// Input of the kernel: rows, incidences and elements.
struct CorotatedRows {
  const BlockPattern& blocks;
  const SymmetricPattern& pattern;
  const CorotatedElements& elements;
};

class CorotatedStiffness {
 public:
  /// Takes elements with 4 corners and one point, or with 10 corners and four points. All arguments must
  /// outlive this object.
  CorotatedStiffness(const Connectivity& elements, const BlockPattern& blocks,
                     const SymmetricPattern& pattern);

  /// Updates the object for the present elements.
  void fit();

  /// Assembles K with the elements' twists. Each row is summed separately, in the order of its elements:
  /// bitwise equal for any number of threads.
  void assemble(const CorotatedElements& elements, SymmetricRows& K) const;

  // ---- K, the warped stiffness (independent of the twists), element by element, in double precision except
  // for the gradients; exactly zero for translations. 3n vectors.
  /// Returns ½uᵀKu.
  double energy(const CorotatedElements& elements, const double* u);
  /// Returns ½uᵀKu and computes f = K·u.
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

}  // namespace prosector
