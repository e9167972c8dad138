#pragma once
// The matrices of turned elements, in single precision and without storing the elements' blocks: row by row
// each block is summed over the elements that share its two nodes.

#include "server/physics/soft/elements/turned_elements.h"
#include "server/physics/soft/matrices/symmetric_rows.h"

namespace prosector {

/// For the kernel: rows, what meets there, and what to sum.
struct TurnedRows {
  const BlockPattern& blocks;
  const SymmetricPattern& pattern;
  const TurnedElements& elements;
};

class TurnedStiffness {
 public:
  /// Takes elements with 4 corners and one point or with 10 and four. All must outlive this.
  TurnedStiffness(const Connectivity& elements, const BlockPattern& blocks, const SymmetricPattern& pattern);

  /// Fits to the elements as they are.
  void fit();

  /// Assembles K with the elements' twists. Each row is summed by itself, its elements in their order: equal
  /// bits for any number of threads.
  void assemble(const TurnedElements& elements, SymmetricRows& K) const;

  // ---- K, the warped stiffness (whatever the twists), element by element, in double but for the gradients;
  // nothing at all on translations. 3n vectors.
  /// Returns ½uᵀKu.
  double energy(const TurnedElements& elements, const double* u);
  /// Returns ½uᵀKu and computes f = K·u.
  double multiply(const TurnedElements& elements, const double* u, double* f);

 private:
  double visit(const TurnedElements& elements, const double* u, Vec3* forces);
  std::size_t corners() const { return connectivity_.element(0).size(); }

  const Connectivity& connectivity_;
  const BlockPattern& blocks_;
  const SymmetricPattern& pattern_;
  std::vector<Vec3> forces_;   // by corner
  std::vector<double> moved_;  // u, four a node
  std::vector<double> sums_;   // one a chunk
};

}  // namespace prosector
