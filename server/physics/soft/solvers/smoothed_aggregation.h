#pragma once
// Coarse spaces for elasticity by smoothed aggregation (Vaněk, Mandel, Brezina 1996): neighbouring nodes form
// an aggregate that moves like a rigid body, its six modes damped once by Jacobi's method.

#include <span>
#include <vector>

#include "server/physics/soft/matrices/block_csr.h"

namespace prosector {

/// One step of coarsening a matrix of B×B blocks: coarse nodes have 6 unknowns each. A mode that an
/// aggregate does not have (a single node's turning) is a column of zeros in P and one on the diagonal.
template <int B>
struct Coarsening {
  std::size_t nodes = 0;                           // coarse
  BlockCsr<B, 6> prolongation;                     // rows without entries: nodes that are left out
  BlockCsr<6, B> restriction;                      // Pᵀ
  BlockCsr<6, 6> matrix;                           // PᵀAP
  std::vector<Eigen::Matrix<double, 6, 6>> modes;  // the rigid modes in the coarse unknowns
};

/// Coarsens A. `modes`: per node, what the six rigid modes do to its unknowns. `left_out`: nodes that
/// something holds so firmly that no coarse space is needed. `eigenvalue`: an upper bound of D⁻¹A's, D its
/// diagonal blocks.
template <int B>
Coarsening<B> coarsen(const BlockCsr<B, B>& A, std::span<const Eigen::Matrix<double, B, 6>> modes,
                      const std::vector<bool>& left_out, double eigenvalue);

/// Returns the largest eigenvalue of D⁻¹A by power iteration, and a tenth more.
template <int B>
double largest_eigenvalue(const BlockCsr<B, B>& A);

}  // namespace prosector
