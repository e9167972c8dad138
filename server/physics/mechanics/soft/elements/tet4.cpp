#include "server/physics/mechanics/soft/elements/tet4.h"

#include <Eigen/LU>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>

#include "common/anatomy/rest_stretch.h"
#include "server/physics/base/parallel.h"

namespace prosector::soft {
namespace {

constexpr std::size_t tets_per_chunk = 512;

/// Returns the edges from node 0 as columns; `at`: position of a node.
template <class At>
Mat3 edges_of(const Tet4Elements::Nodes& tet, const At& at) {
  Mat3 D;
  for (int a = 0; a < 3; ++a) D.col(a) = at(tet[static_cast<std::size_t>(a) + 1]) - at(tet[0]);
  return D;
}

Mat3 rest_edges(const TetMesh& mesh, const Tet4Elements::Nodes& tet) {
  return edges_of(tet, [&](std::uint32_t node) -> const Vec3& { return mesh.positions[node]; });
}

double longest_edge(const Mat3& D) {
  const double from_0 = D.colwise().squaredNorm().maxCoeff();
  const double others = std::max({(D.col(0) - D.col(1)).squaredNorm(), (D.col(1) - D.col(2)).squaredNorm(),
                                  (D.col(2) - D.col(0)).squaredNorm()});
  return std::sqrt(std::max(from_0, others));
}

bool usable(const Mat3& D) {
  const double length = longest_edge(D);
  return std::abs(D.determinant()) > Tet4Elements::least_quality * length * length * length;
}

}  // namespace

Tet4Elements::Tet4Elements(const TetMesh& mesh)
    : nodes_(mesh.tets.size()),
      source_(mesh.tets.size()),
      gradients_(mesh.tets.size()),
      volume_(mesh.tets.size()) {
  parallel_chunks(mesh.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) set(t, mesh);
  });
  drop_unusable();
}

Tet4Elements Tet4Elements::parted(const Tet4Elements& elements, std::size_t parts) {
  Tet4Elements out;
  out.resize(parts * elements.size());
  parallel_chunks(elements.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e) out.set_parts(e, parts, elements);
  });
  return out;
}

void Tet4Elements::follow_parted(const Tet4Elements& elements, const MeshEdit& edit) {
  const std::size_t parts = size() / edit.kept_tets.before;
  edit.kept_tets.carry(gradients_, parts);
  edit.kept_tets.carry(volume_, parts);
  resize(parts * edit.kept_tets.now);
  for (const std::uint32_t e : edit.tets) set_parts(e, parts, elements);
}

/// Resizes to `size` elements; added elements have no corners in common.
void Tet4Elements::resize(std::size_t size) {
  const std::size_t first = std::min(size, nodes_.size());
  nodes_.resize(size);
  source_.resize(size);
  gradients_.resize(size);
  volume_.resize(size);
  for (std::size_t e = first; e < size; ++e) {
    const auto corner = static_cast<std::uint32_t>(4 * e);
    nodes_[e] = {corner, corner + 1, corner + 2, corner + 3};
    source_[e] = static_cast<std::uint32_t>(e);
  }
}

void Tet4Elements::set_parts(std::size_t e, std::size_t parts, const Tet4Elements& elements) {
  for (std::size_t part = parts * e; part < parts * (e + 1); ++part) {
    gradients_[part] = elements.gradients_[e];
    volume_[part] = elements.volume_[e] / static_cast<double>(parts);
  }
}

/// Sets element e to tetrahedron e; its volume is 0 if the tetrahedron is not usable.
void Tet4Elements::set(std::size_t e, const TetMesh& mesh) {
  nodes_[e] = mesh.tets[e];
  source_[e] = static_cast<std::uint32_t>(e);
  std::sort(nodes_[e].begin(), nodes_[e].end());
  const Mat3 D = rest_edges(mesh, nodes_[e]);
  const bool kept = usable(D);
  volume_[e] = kept ? std::abs(D.determinant()) / 6 : 0;
  gradients_[e] = kept ? Mat3(D.inverse().transpose()) : Mat3(Mat3::Zero());
  if (kept && mesh.stretch) set_stretch(e, mesh.stretch->at(middle_of(mesh, nodes_[e])));
}

/// Makes V the element's Fe at rest: Fe = F·V = Σ_a x_a (V·b_a)ᵀ; its stress-free volume is V0/det V. So laws
/// and solvers need not handle prestretch (rest_stretch.h).
void Tet4Elements::set_stretch(std::size_t e, const Mat3& stretch) {
  gradients_[e] = (stretch * gradients_[e]).eval();
  volume_[e] /= stretch.determinant();
}

bool Tet4Elements::can_follow(const VecX& rest, const MeshEdit& edit) const {
  if (dropped_ > 0 || size() != edit.kept_tets.before) return false;
  std::vector<Vec3> positions(edit.kept_nodes.now);
  for (const Kept::Run& run : edit.kept_nodes.runs)
    for (std::uint32_t i = 0; i < run.count; ++i)
      positions[run.to + i] = rest.segment<3>(3 * Eigen::Index{run.from + i});
  for (std::size_t i = 0; i < edit.made_nodes.size(); ++i) positions[edit.made_nodes[i]] = edit.positions[i];
  const auto at = [&](std::uint32_t node) -> const Vec3& { return positions[node]; };
  std::atomic<bool> all_usable = true;
  parallel_chunks(edit.corners.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) {
      Nodes tet = edit.corners[i];
      std::sort(tet.begin(), tet.end());
      if (!usable(edges_of(tet, at))) all_usable = false;
    }
  });
  return all_usable;
}

void Tet4Elements::follow(const TetMesh& mesh, const MeshEdit& edit) {
  const Kept& kept = edit.kept_tets;
  kept.carry(nodes_);
  kept.carry(gradients_);
  kept.carry(volume_);
  if (!edit.kept_nodes.all_unmoved()) {
    const std::vector<std::uint32_t> now = edit.kept_nodes.destinations();
    for (Nodes& element : nodes_)
      for (std::uint32_t& node : element) node = now[node];
  }
  source_.resize(kept.now);
  std::iota(source_.begin(), source_.end(), 0U);
  parallel_chunks(edit.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t i = first; i < last; ++i) set(edit.tets[i], mesh);
  });
}

/// Removes the elements without volume.
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
    // Columns contracted with b_b; rows are still those of vec(P).
    const Vec3 w = volume_[e] * B.col(b);
    const Eigen::Matrix<double, 9, 3> q =
        w[0] * dPdF.leftCols<3>() + w[1] * dPdF.middleCols<3>(3) + w[2] * dPdF.rightCols<3>();
    for (int a = 0; a < b; ++a) {
      K[static_cast<std::size_t>(pair_index(a, b))] =
          B(0, a) * q.topRows<3>() + B(1, a) * q.middleRows<3>(3) + B(2, a) * q.bottomRows<3>();
    }
  }
}

double Tet4Elements::lumped_share(const TetMesh& mesh, std::size_t tet) {
  return std::abs(rest_edges(mesh, mesh.tets[tet]).determinant()) / 24;
}

VecX Tet4Elements::lumped_volume(const TetMesh& mesh) {
  std::vector<double> share(mesh.tets.size());
  parallel_chunks(mesh.tets.size(), tets_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) share[t] = lumped_share(mesh, t);
  });
  VecX volume = VecX::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (std::uint32_t node : mesh.tets[t]) volume[node] += share[t];
  return volume;
}

}  // namespace prosector::soft
