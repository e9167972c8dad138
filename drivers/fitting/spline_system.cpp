#include "drivers/fitting/spline_system.h"

namespace prosector {

SplineSolution solve_spline(std::span<const Vec3> nodes, const Eigen::MatrixXd& polynomials,
                            double (*kernel)(double), double diagonal, const Eigen::MatrixXd& values) {
  const auto n = static_cast<Eigen::Index>(nodes.size());
  const Eigen::Index terms = polynomials.cols();
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n + terms, n + terms);
  for (Eigen::Index i = 0; i < n; ++i) {
    m(i, i) = diagonal;
    for (Eigen::Index j = 0; j < i; ++j)
      m(i, j) = m(j, i) =
          kernel((nodes[static_cast<std::size_t>(i)] - nodes[static_cast<std::size_t>(j)]).norm());
  }
  m.topRightCorner(n, terms) = polynomials;
  m.bottomLeftCorner(terms, n) = polynomials.transpose();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n + terms, values.cols());
  right.topRows(n) = values;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(m);
  return {lu.solve(right), lu.matrixLU().diagonal().array().abs().log().sum()};
}

}  // namespace prosector
