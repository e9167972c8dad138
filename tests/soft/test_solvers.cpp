// Solvers against dense algebra, also where the factor misses a part of the matrix, as with contacts.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <random>
#include <string>

#include "common/error.h"
#include "server/physics/mechanics/soft/solvers/linear_solver.h"

namespace prosector {
namespace {

/// H = A + CᵀC with the factor of A alone.
class DenseOperator final : public soft::LinearOperator {
 public:
  DenseOperator(Eigen::Index n, Eigen::Index contacts) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    const auto draw = [&] { return normal(random); };
    const Eigen::MatrixXd B = Eigen::MatrixXd::NullaryExpr(n, n, draw);
    A = B * B.transpose() + 0.1 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::MatrixXd C = 30 * Eigen::MatrixXd::NullaryExpr(contacts, n, draw);
    H = A + C.transpose() * C;
    b = VecX::NullaryExpr(n, draw);
    factor.compute(A);
  }
  Eigen::Index size() const override { return H.rows(); }
  void multiply(const VecX& p, VecX& Hp) const override { Hp.noalias() = H * p; }
  void block_jacobi(const VecX& r, VecX& z) const override {
    for (Eigen::Index i = 0; i < size(); i += 3) {
      z.segment<3>(i) = Mat3(H.block<3, 3>(i, i)).inverse() * r.segment<3>(i);
    }
  }
  void elastic_factor(const VecX& r, VecX& z) const override { z = factor.solve(r); }
  void multigrid(const VecX& r, VecX& z) const override { block_jacobi(r, z); }

  Eigen::MatrixXd A, H;
  VecX b;
  Eigen::LLT<Eigen::MatrixXd> factor;
};

TEST(Solvers, AgreeWithDense) {
  for (const soft::SolverRow& row : soft::solvers()) {
    for (Eigen::Index contacts : {0, 4}) {
      const DenseOperator H(60, contacts);
      const auto solver = row.make();
      VecX x = VecX::Zero(60), again = x;
      const soft::SolveReport report = solver->solve(H, H.b, {2000, 1e-9}, x);
      EXPECT_TRUE(report.converged) << row.name;
      const VecX exact = H.H.ldlt().solve(H.b);
      EXPECT_LT((x - exact).norm(), 1e-6 * exact.norm()) << row.name;
      solver->solve(H, H.b, {2000, 1e-9}, again);
      EXPECT_EQ(x, again) << row.name;  // bit for bit, also with a used work space
    }
  }
}

TEST(Solvers, DirectTakesOneIterationAndAFewWithContacts) {
  const auto solver = soft::make_solver("direct");
  for (Eigen::Index contacts : {0, 4}) {
    const DenseOperator H(60, contacts);
    VecX x = VecX::Zero(60);
    EXPECT_LE(solver->solve(H, H.b, {60, 1e-8}, x).iterations, contacts + 3);
  }
  const DenseOperator H(60, 0);
  VecX x = VecX::Zero(60);
  EXPECT_EQ(solver->solve(H, H.b, {60, 1e-3}, x).iterations, 1);
}

TEST(Solvers, ReportTheTrueResidual) {
  const DenseOperator H(90, 0);
  const auto solver = soft::make_solver("cg");
  for (int cap : {0, 1, 10}) {
    VecX x = VecX::Zero(90), z(90);
    const soft::SolveReport report = solver->solve(H, H.b, {cap, 1e-12}, x);
    const auto norm = [&](const VecX& v) {
      H.block_jacobi(v, z);
      return std::sqrt(v.dot(z));
    };
    EXPECT_EQ(report.iterations, cap);
    EXPECT_FALSE(report.converged);
    EXPECT_NEAR(report.residual, norm(H.b - H.H * x) / norm(H.b), 1e-9);
  }
}

TEST(Solvers, SurviveWhatCannotBeSolved) {
  for (const soft::SolverRow& row : soft::solvers()) {
    DenseOperator H(30, 0);
    VecX x = VecX::Ones(30);
    EXPECT_TRUE(row.make()->solve(H, VecX::Zero(30), {}, x).converged);
    EXPECT_EQ(x, VecX::Zero(30));
    VecX b = H.b;
    b[3] = NAN;
    EXPECT_FALSE(row.make()->solve(H, b, {}, x).converged) << row.name;
    EXPECT_TRUE(x.allFinite());
    x.setConstant(NAN);
    EXPECT_TRUE(row.make()->solve(H, H.b, {500, 1e-6}, x).converged) << row.name;
    H.H *= -1;
    x.setZero();
    EXPECT_FALSE(row.make()->solve(H, H.b, {}, x).converged) << row.name;
    EXPECT_TRUE(x.allFinite());
  }
}

TEST(Solvers, ErrorListsTheRows) {
  try {
    soft::make_solver("magic");
    FAIL();
  } catch (const InputError& error) {
    for (const auto& row : soft::solvers())
      EXPECT_NE(std::string(error.what()).find(row.name), std::string::npos);
  }
}

}  // namespace
}  // namespace prosector
