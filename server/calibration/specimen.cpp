#include "server/calibration/specimen.h"

#include <Eigen/SVD>
#include <limits>
#include <stdexcept>

namespace prosector {
namespace {

/// Returns sum + Σ m_i·f(i).
template <class T, class F>
T mass_sum(const Specimen& specimen, T sum, const F& f) {
  const VecX& mass = specimen.node_mass();
  for (Eigen::Index i = 0; i < mass.size(); ++i) sum += mass[i] * f(3 * i);
  return sum;
}

}  // namespace

double Specimen::weight_energy(const Vec3& gravity) const {
  return -node_mass().sum() * gravity.dot(mass_center(*this));
}

Vec3 mass_center(const Specimen& specimen) {
  const VecX x = specimen.positions();
  const Vec3 sum = mass_sum(specimen, Vec3(Vec3::Zero()), [&](Eigen::Index k) { return x.segment<3>(k); });
  return sum / specimen.node_mass().sum();
}

Vec3 momentum(const Specimen& specimen) {
  const VecX v = specimen.velocities();
  return mass_sum(specimen, Vec3(Vec3::Zero()), [&](Eigen::Index k) { return v.segment<3>(k); });
}

Vec3 angular_momentum(const Specimen& specimen) {
  const VecX x = specimen.positions(), v = specimen.velocities();
  return mass_sum(specimen, Vec3(Vec3::Zero()),
                  [&](Eigen::Index k) -> Vec3 { return Vec3(x.segment<3>(k)).cross(Vec3(v.segment<3>(k))); });
}

double kinetic_energy(const Specimen& specimen) {
  const VecX v = specimen.velocities();
  return mass_sum(specimen, 0.0, [&](Eigen::Index k) { return v.segment<3>(k).squaredNorm() / 2; });
}

double volume(const TetMesh& mesh, const VecX& x) {
  double six = 0;
  for (const auto& tet : mesh.tets) {
    const Vec3 a = x.segment<3>(3 * tet[0]);
    Mat3 edges;
    for (int c = 0; c < 3; ++c) edges.col(c) = x.segment<3>(3 * tet[static_cast<std::size_t>(c) + 1]) - a;
    six += edges.determinant();
  }
  return six / 6;
}

double shape_error(const VecX& rest, const VecX& x, const VecX& node_mass) {
  if (!x.allFinite()) return std::numeric_limits<double>::infinity();
  const auto at_rest = rest.reshaped(3, node_mass.size()), now = x.reshaped(3, node_mass.size());
  const Vec3 rest_center = at_rest * node_mass / node_mass.sum(), center = now * node_mass / node_mass.sum();
  const Mat3 covariance =
      (now.colwise() - center) * node_mass.asDiagonal() * (at_rest.colwise() - rest_center).transpose();
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sense = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Mat3 turn = svd.matrixU() * Vec3(1, 1, sense).asDiagonal() * svd.matrixV().transpose();
  return ((now.colwise() - center) - turn * (at_rest.colwise() - rest_center)).colwise().norm().maxCoeff();
}

Eigen::Index node_at(const VecX& rest, const Vec3& place) {
  for (Eigen::Index i = 0; i < rest.size() / 3; ++i) {
    if ((rest.segment<3>(3 * i) - place).norm() < 1e-9) return i;
  }
  throw std::logic_error(
      "the benchmark specimen's mesh has no node at the position whose displacement is measured");
}

}  // namespace prosector
