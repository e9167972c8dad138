#include "server/physics/mechanics/soft/solvers/smoothed_aggregation.h"

#include <Eigen/LU>
#include <cmath>

namespace prosector::soft {
namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr int power_iterations = 20;
constexpr std::size_t aggregates_per_chunk = 16;
// Relative to a mode's size: the part that must remain after orthogonalisation for an aggregate to have the
// mode.
constexpr double least_mode = 1e-6;

/// Aggregates nodes greedily in their order (Vaněk et al. 1996, alg. 2). Whole neighbourhoods come first,
/// then remaining nodes join a neighbour's aggregate, then the rest form aggregates with each other.
template <int B>
std::vector<std::uint32_t> aggregate(const BlockCsr<B, B>& A, const std::vector<bool>& left_out,
                                     std::size_t& count) {
  std::vector<std::uint32_t> of(A.rows(), none);
  const auto neighbours = [&](std::size_t i) {
    return std::span(A.column).subspan(A.begin[i], A.begin[i + 1] - A.begin[i]);
  };
  const auto take_neighbourhood = [&](std::size_t i) {
    for (std::uint32_t j : neighbours(i))
      if (!left_out[j] && of[j] == none) of[j] = static_cast<std::uint32_t>(count);
    ++count;
  };
  count = 0;
  for (std::size_t i = 0; i < A.rows(); ++i) {
    bool whole = !left_out[i];
    for (std::uint32_t j : neighbours(i)) whole = whole && of[j] == none;
    if (whole) take_neighbourhood(i);
  }
  const std::vector<std::uint32_t> first = of;
  for (std::size_t i = 0; i < A.rows(); ++i) {
    if (left_out[i] || of[i] != none) continue;
    for (std::uint32_t j : neighbours(i))
      if (first[j] != none) {
        of[i] = first[j];
        break;
      }
  }
  for (std::size_t i = 0; i < A.rows(); ++i)
    if (!left_out[i] && of[i] == none) take_neighbourhood(i);
  return of;
}

/// Orthonormalises the aggregate's modes (modified Gram–Schmidt) and computes the triangular factor R. A mode
/// that the aggregate lacks, as the rotation of a single node, becomes a column of zeros.
void orthonormalise(Eigen::MatrixXd& Q, Eigen::Matrix<double, 6, 6>& R) {
  R.setZero();
  for (int k = 0; k < 6; ++k) {
    const double size = Q.col(k).norm();
    for (int again = 0; again < 2; ++again)
      for (int j = 0; j < k; ++j) {
        const double along = Q.col(j).dot(Q.col(k));
        R(j, k) += along;
        Q.col(k) -= along * Q.col(j);
      }
    const double left = Q.col(k).norm();
    if (left > least_mode * size) {
      R(k, k) = left;
      Q.col(k) /= left;
    } else {
      Q.col(k).setZero();
    }
  }
}

/// Removes all entries of these rows.
template <int R, int C>
void drop_rows(const std::vector<bool>& which, BlockCsr<R, C>& A) {
  std::size_t to = 0;
  for (std::size_t i = 0, from = 0; i < A.rows(); ++i) {
    const std::size_t end = A.begin[i + 1];
    for (; from < end; ++from) {
      if (which[i]) continue;
      A.column[to] = A.column[from];
      A.value[to++] = A.value[from];
    }
    A.begin[i + 1] = to;
  }
  A.column.resize(to);
  A.value.resize(to);
}

}  // namespace

template <int B>
double largest_eigenvalue(const BlockCsr<B, B>& A) {
  const auto inverse = inverse_diagonal(A);
  const auto n = static_cast<Eigen::Index>(A.rows());
  VecX x(B * n), y(B * n);
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 + 12.9898 * static_cast<double>(i));
  double size = 1;
  for (int iteration = 0; iteration < power_iterations; ++iteration) {
    x /= x.norm();
    parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
      for (std::size_t row = first; row < last; ++row) {
        Eigen::Matrix<double, B, 1> sum = Eigen::Matrix<double, B, 1>::Zero();
        for (std::size_t k = A.begin[row]; k < A.begin[row + 1]; ++k)
          sum += A.value[k] * x.template segment<B>(B * static_cast<Eigen::Index>(A.column[k]));
        y.template segment<B>(B * static_cast<Eigen::Index>(row)) = inverse[row] * sum;
      }
    });
    size = y.norm();
    x.swap(y);
  }
  return 1.1 * size;
}

template <int B>
Coarsening<B> coarsen(const BlockCsr<B, B>& A, std::span<const Eigen::Matrix<double, B, 6>> modes,
                      const std::vector<bool>& left_out, double eigenvalue) {
  Coarsening<B> out;
  const std::vector<std::uint32_t> of = aggregate(A, left_out, out.nodes);
  std::vector<std::vector<std::uint32_t>> members(out.nodes);
  for (std::uint32_t i = 0; i < of.size(); ++i)
    if (of[i] != none) members[of[i]].push_back(i);

  std::vector<Eigen::Matrix<double, B, 6>> tentative(A.rows());
  out.modes.resize(out.nodes);
  parallel_chunks(out.nodes, aggregates_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t a = first; a < last; ++a) {
      Eigen::MatrixXd Q(B * static_cast<Eigen::Index>(members[a].size()), 6);
      for (std::size_t m = 0; m < members[a].size(); ++m)
        Q.middleRows<B>(B * static_cast<Eigen::Index>(m)) = modes[members[a][m]];
      orthonormalise(Q, out.modes[a]);
      for (std::size_t m = 0; m < members[a].size(); ++m)
        tentative[members[a][m]] = Q.middleRows<B>(B * static_cast<Eigen::Index>(m));
    }
  });

  BlockCsr<B, 6> T;
  T.reserve(A.rows(), A.rows());
  for (std::size_t i = 0; i < A.rows(); ++i) {
    if (of[i] != none) T.add(of[i], tentative[i]);
    T.close_row();
  }
  // P = (I − ω D⁻¹A) T, without the rows of nodes left out.
  const double omega = 4 / (3 * eigenvalue);
  const auto inverse = inverse_diagonal(A);
  out.prolongation = product(A, T, out.nodes);
  drop_rows(left_out, out.prolongation);
  parallel_chunks(A.rows(), csr_rows_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    BlockCsr<B, 6>& P = out.prolongation;
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = P.begin[i]; k < P.begin[i + 1]; ++k) {
        P.value[k] = (-omega * inverse[i] * P.value[k]).eval();
        if (P.column[k] == of[i]) P.value[k] += tentative[i];
      }
  });
  out.restriction = transposed(out.prolongation, out.nodes);
  out.matrix = product(out.restriction, product(A, out.prolongation, out.nodes), out.nodes);
  for (std::size_t a = 0; a < out.nodes; ++a)
    for (std::size_t k = out.matrix.begin[a]; k < out.matrix.begin[a + 1]; ++k)
      if (out.matrix.column[k] == a)
        for (int mode = 0; mode < 6; ++mode)
          if (out.modes[a](mode, mode) == 0) out.matrix.value[k](mode, mode) = 1;
  return out;
}

template double largest_eigenvalue(const BlockCsr<3, 3>&);
template double largest_eigenvalue(const BlockCsr<6, 6>&);
template Coarsening<3> coarsen(const BlockCsr<3, 3>&, std::span<const Eigen::Matrix<double, 3, 6>>,
                               const std::vector<bool>&, double);
template Coarsening<6> coarsen(const BlockCsr<6, 6>&, std::span<const Eigen::Matrix<double, 6, 6>>,
                               const std::vector<bool>&, double);

}  // namespace prosector::soft
