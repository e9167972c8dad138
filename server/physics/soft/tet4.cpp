#include "server/physics/soft/tet4.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "server/physics/parallel.h"

namespace prosector {
namespace {

constexpr std::size_t tets_per_chunk = 512;

/// Edges from node 0 as columns.
Mat3 rest_edges(const TetMesh& mesh, const Tet4Elements::Nodes& tet) {
  Mat3 D;
  for (int a = 0; a < 3; ++a) {
    D.col(a) = mesh.positions[tet[static_cast<std::size_t>(a) + 1]] - mesh.positions[tet[0]];
  }
  return D;
}

double longest_edge(const Mat3& D) {
  const double from_0 = D.colwise().squaredNorm().maxCoeff();
  const double others = std::max({(D.col(0) - D.col(1)).squaredNorm(), (D.col(1) - D.col(2)).squaredNorm(),
                                  (D.col(2) - D.col(0)).squaredNorm()});
  return std::sqrt(std::max(from_0, others));
}

}  // namespace

Tet4Elements::Tet4Elements(const TetMesh& mesh, double share)
    : nodes_(mesh.tets.size()),
      source_(mesh.tets.size()),
      gradients_(mesh.tets.size()),
      volume_(mesh.tets.size()) {
  parallel_chunks(mesh.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) {
      nodes_[t] = mesh.tets[t];
      source_[t] = static_cast<std::uint32_t>(t);
      std::sort(nodes_[t].begin(), nodes_[t].end());
      const Mat3 D = rest_edges(mesh, nodes_[t]);
      const double six_volumes = std::abs(D.determinant()), length = longest_edge(D);
      const bool usable = six_volumes > least_quality * length * length * length;
      volume_[t] = usable ? share * (six_volumes / 6) : 0;
      gradients_[t] = usable ? Mat3(D.inverse().transpose()) : Mat3(Mat3::Zero());
    }
  });
  drop_unusable();
}

/// Those without a volume.
void Tet4Elements::drop_unusable() {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < volume_.size(); ++t) {
    if (volume_[t] == 0) continue;
    nodes_[kept] = nodes_[t];
    source_[kept] = source_[t];
    gradients_[kept] = gradients_[t];
    volume_[kept++] = volume_[t];
  }
  dropped_ = volume_.size() - kept;
  nodes_.resize(kept);
  source_.resize(kept);
  gradients_.resize(kept);
  volume_.resize(kept);
}

Mat3 Tet4Elements::edges(std::size_t e, const double* x) const {
  const Nodes& n = nodes_[e];
  const auto at = [&](std::size_t a) { return Eigen::Map<const Vec3>(x + 3 * std::size_t{n[a]}); };
  const Vec3 x0 = at(0);
  Mat3 D;
  D.col(0) = at(1) - x0;
  D.col(1) = at(2) - x0;
  D.col(2) = at(3) - x0;
  return D;
}

void Tet4Elements::forces(std::size_t e, const Mat3& P, Forces& f) const {
  const Mat3 G = volume_[e] * P * gradients_[e];
  f[1] = G.col(0);
  f[2] = G.col(1);
  f[3] = G.col(2);
  f[0] = -(f[1] + f[2] + f[3]);
}

void Tet4Elements::stiffness(std::size_t e, const Mat9& dPdF, Stiffness& K) const {
  Eigen::Matrix<double, 3, 4> B;
  B.rightCols<3>() = gradients_[e];
  B.col(0) = -B.rightCols<3>().rowwise().sum();
  for (int b = 1; b < nodes_per_element; ++b) {
    // Columns contracted with b_b: rows are still those of vec(P).
    const Vec3 w = volume_[e] * B.col(b);
    const Eigen::Matrix<double, 9, 3> q =
        w[0] * dPdF.leftCols<3>() + w[1] * dPdF.middleCols<3>(3) + w[2] * dPdF.rightCols<3>();
    for (int a = 0; a < b; ++a) {
      K[static_cast<std::size_t>(pair_index(a, b))] =
          B(0, a) * q.topRows<3>() + B(1, a) * q.middleRows<3>(3) + B(2, a) * q.bottomRows<3>();
    }
  }
}

VecX Tet4Elements::lumped_volume(const TetMesh& mesh) {
  std::vector<double> share(mesh.tets.size());
  parallel_chunks(mesh.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t)
      share[t] = std::abs(rest_edges(mesh, mesh.tets[t]).determinant()) / 24;
  });
  VecX volume = VecX::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::uint32_t node : mesh.tets[t]) volume[node] += share[t];
  return volume;
}

}  // namespace prosector
