#include "server/calibration/specimen.h"

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

}  // namespace prosector
