#pragma once
// Coarse spaces for elasticity by smoothed aggregation (Vaněk, Mandel, Brezina 1996): neighbouring nodes form
// an aggregate that moves as a rigid body. The aggregate's six modes are smoothed by one Jacobi step.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/matrices/block_csr.h"

namespace prosector {

/// One coarsening step of a matrix of B×B blocks: coarse nodes have 6 unknowns each. A mode that an aggregate
/// lacks (the rotation of a single node) is a column of zeros in P and one on the diagonal.
template <int B>
struct Coarsening {
  std::size_t nodes = 0;                           // number of coarse nodes
  BlockCsr<B, 6> prolongation;                     // rows without entries belong to nodes that are left out
  BlockCsr<6, B> restriction;                      // Pᵀ
  BlockCsr<6, 6> matrix;                           // PᵀAP
  std::vector<Eigen::Matrix<double, 6, 6>> modes;  // the rigid modes in the coarse unknowns
};

/// Coarsens A. `modes`: per node, the effect of the six rigid modes on its unknowns. `left_out`: nodes that
/// are attached so firmly that they need no coarse space. `eigenvalue`: an upper bound of the eigenvalues of
/// D⁻¹A, D the diagonal blocks.
template <int B>
Coarsening<B> coarsen(const BlockCsr<B, B>& A, std::span<const Eigen::Matrix<double, B, 6>> modes,
                      const std::vector<bool>& left_out, double eigenvalue);

/// Returns 1.1 times the largest eigenvalue of D⁻¹A, by power iteration.
template <int B>
double largest_eigenvalue(const BlockCsr<B, B>& A);

}  // namespace prosector
