#include "server/physics/mechanics/soft/solvers/conjugate_gradient.h"

#include <cmath>
#include <limits>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"

namespace prosector::soft {
namespace {

using Preconditioner = void (LinearOperator::*)(const VecX& r, VecX& z) const;

constexpr std::size_t entries_per_chunk = 8192;
/// Iterations up to which the recurrence's residual is accurate enough. Later it drifts by rounding errors,
/// and the true residual is computed.
constexpr int trusted_iterations = 100;

/// Calls f(i) for all entries of vectors of n.
template <class F>
void for_entries(Eigen::Index n, const F& f) {
  parallel_short_chunks(
      static_cast<std::size_t>(n), entries_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
        for (auto i = static_cast<Eigen::Index>(first); i < static_cast<Eigen::Index>(last); ++i) f(i);
      });
}

/// Dot products, summed chunk by chunk, with bitwise equal results for any number of threads.
class Dot {
 public:
  double operator()(const VecX& a, const VecX& b) {
    sums_.resize(chunk_count(static_cast<std::size_t>(a.size()), entries_per_chunk));
    parallel_short_chunks(static_cast<std::size_t>(a.size()), entries_per_chunk,
                          [&](std::size_t first, std::size_t last, std::size_t chunk) {
                            const auto begin = static_cast<Eigen::Index>(first),
                                       n = static_cast<Eigen::Index>(last - first);
                            sums_[chunk] = a.segment(begin, n).dot(b.segment(begin, n));
                          });
    return ordered_sum(sums_);
  }

 private:
  std::vector<double> sums_;
};

class ConjugateGradient final : public LinearSolver {
 public:
  explicit ConjugateGradient(Preconditioner preconditioner) : precondition_(preconditioner) {}

  SolveReport solve(const LinearOperator& H, const VecX& b, const SolverSettings& settings,
                    VecX& x) override {
    resize(b.size());
    SolveReport report;
    const double b_norm = preconditioned_norm(H, b);
    if (b_norm == 0) {
      x.setZero();
      report.converged = true;
      return report;
    }
    const double goal = settings.tolerance * b_norm;
    if (!x.allFinite()) x.setZero();
    if (x.isZero(0)) {
      r_ = b;  // and z_ has been preconditioned above
    } else {
      residual(H, b, x);
      (H.*precondition_)(r_, z_);
    }
    double rho = dot_(r_, z_);
    p_ = z_;
    while (report.iterations < settings.max_iterations && std::sqrt(rho) > goal) {
      H.multiply(p_, q_);
      const double curvature = dot_(p_, q_);
      if (!(curvature > 0) || !std::isfinite(curvature)) break;  // not positive definite, or not finite
      const double step = rho / curvature;
      for_entries(x.size(), [&](Eigen::Index i) {
        x[i] += step * p_[i];
        r_[i] -= step * q_[i];
      });
      ++report.iterations;
      (H.*precondition_)(r_, z_);
      const double rho_next = dot_(r_, z_);
      const double keep = rho_next / rho;
      for_entries(x.size(), [&](Eigen::Index i) { p_[i] = z_[i] + keep * p_[i]; });
      rho = rho_next;
    }
    if (report.iterations > trusted_iterations) {
      residual(H, b, x);
      report.residual = preconditioned_norm(H, r_) / b_norm;
    } else {
      report.residual = std::sqrt(rho) / b_norm;
    }
    report.converged = report.residual <= 1.01 * settings.tolerance;
    if (!std::isfinite(report.residual)) {
      x.setZero();
      report.residual = std::numeric_limits<double>::infinity();
    }
    return report;
  }

 private:
  void resize(Eigen::Index n) {
    for (VecX* v : {&r_, &z_, &p_, &q_}) v->resize(n);
  }
  void residual(const LinearOperator& H, const VecX& b, const VecX& x) {
    H.multiply(x, q_);
    r_ = b - q_;
  }
  double preconditioned_norm(const LinearOperator& H, const VecX& v) {
    (H.*precondition_)(v, z_);
    return std::sqrt(dot_(v, z_));
  }

  Preconditioner precondition_;
  VecX r_, z_, p_, q_;
  Dot dot_;
};

}  // namespace

std::unique_ptr<LinearSolver> make_cg() {
  return std::make_unique<ConjugateGradient>(&LinearOperator::block_jacobi);
}

std::unique_ptr<LinearSolver> make_multigrid() {
  return std::make_unique<ConjugateGradient>(&LinearOperator::multigrid);
}

std::unique_ptr<LinearSolver> make_direct() {
  return std::make_unique<ConjugateGradient>(&LinearOperator::elastic_factor);
}

}  // namespace prosector::soft
