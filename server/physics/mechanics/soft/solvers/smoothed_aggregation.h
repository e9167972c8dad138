#pragma once
// Coarse spaces for elasticity by smoothed aggregation (Vaněk, Mandel, Brezina 1996): neighbouring nodes form
// an aggregate that moves as a rigid body. The aggregate's six modes are smoothed by one Jacobi step.

#include <span>
#include <vector>

#include "server/physics/mechanics/soft/matrices/block_csr.h"

namespace prosector::soft {

/// One coarsening step of multigrid for a matrix A of B×B blocks: the prolongation P, the restriction Pᵀ and
/// the coarse matrix PᵀAP. Each coarse node is an aggregate of fine nodes with 6 unknowns, its rigid modes. A
/// mode that an aggregate lacks, such as the rotation of a single node, is a column of zeros in P and a one
/// on the coarse diagonal.
template <int B>
struct Coarsening {
  std::size_t nodes = 0;                           // number of coarse nodes
  BlockCsr<B, 6> prolongation;                     // rows without entries belong to nodes that are left out
  BlockCsr<6, B> restriction;                      // Pᵀ
  BlockCsr<6, 6> matrix;                           // PᵀAP
  std::vector<Eigen::Matrix<double, 6, 6>> modes;  // the rigid modes in the coarse unknowns
};

/// Computes a coarse level for the matrix A by smoothed aggregation. `modes`: for each node, the effect of
/// the body's six rigid modes on its unknowns. `left_out`: nodes that are attached so firmly that they need
/// no coarse space. `eigenvalue`: an upper bound of the eigenvalues of D⁻¹A, where D is A's block diagonal.
template <int B>
Coarsening<B> coarsen(const BlockCsr<B, B>& A, std::span<const Eigen::Matrix<double, B, 6>> modes,
                      const std::vector<bool>& left_out, double eigenvalue);

/// Returns 1.1 times an estimate, by power iteration, of the largest eigenvalue of D⁻¹A, where D is A's block
/// diagonal. The factor makes it an upper bound.
template <int B>
double largest_eigenvalue(const BlockCsr<B, B>& A);

}  // namespace prosector::soft
