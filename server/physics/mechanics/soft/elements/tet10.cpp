#include "server/physics/mechanics/soft/elements/tet10.h"

#include <algorithm>

#include "server/physics/base/parallel.h"
#include "server/physics/mechanics/soft/elements/tet10_shares.h"

namespace prosector::soft {
namespace {

/// Returns column n of T_q with all four entries.
constexpr std::array<double, 4> weights_of(std::size_t point, std::size_t node) {
  const Tet10Share& s = tet10_shares[point][node];
  std::array<double, 4> w{};
  for (std::size_t k = 0; k < s.count; ++k) w[s.corner[k]] = s.weight[k];
  return w;
}
// The b_c sum to zero and the rules are the same for each corner, so Σ|Σ_c w_c b_c|² = Σ(w_0² −
// w_0w_1)·Σ|b_c|².
constexpr double find_squares_of_points() {
  double sum = 0;
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t n = 0; n < 10; ++n) {
      const auto w = weights_of(q, n);
      sum += w[0] * (w[0] - w[1]);
    }
  return sum;
}
constexpr double find_squares_of_sums() {
  double sum = 0;
  for (std::size_t n = 0; n < 10; ++n) {
    std::array<double, 2> w{};
    for (std::size_t q = 0; q < 4; ++q)
      for (std::size_t c = 0; c < 2; ++c) w[c] += weights_of(q, n)[c];
    sum += w[0] * (w[0] - w[1]);
  }
  return sum;
}

constexpr std::size_t elements_per_chunk = 512;

/// Returns the volume of tetrahedron t, m³.
double volume_of(const TetMesh& mesh, std::size_t t) {
  const auto& tet = mesh.tets[t];
  const Vec3& x = mesh.positions[tet[0]];
  return std::abs(
             (mesh.positions[tet[1]] - x).cross(mesh.positions[tet[2]] - x).dot(mesh.positions[tet[3]] - x)) /
         6;
}
/// Returns the share of node n in an element's volume V.
double lumped_share(double V, std::size_t n) {
  return n < 4 ? V / 36 : 4 * V / 27;
}
/// Returns the integral of the shape function of node n over an element of volume V.
double shape_share(double V, std::size_t n) {
  return n < 4 ? -V / 20 : V / 5;
}

}  // namespace

const double Tet10Elements::squares_of_points = find_squares_of_points();
const double Tet10Elements::squares_of_sums = find_squares_of_sums();

Tet10Elements::Tet10Elements(const TetMesh& mesh)
    : corners_(mesh),
      volume_(VecX::Zero(static_cast<Eigen::Index>(mesh.positions.size()))),
      shape_volume_(volume_) {
  const EdgeNodes edges = EdgeNodes::of(mesh);
  std::vector<Nodes> all(mesh.tets.size());
  std::vector<double> volume(mesh.tets.size());
  parallel_chunks(all.size(), elements_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t t = first; t < last; ++t) {
      Nodes& nodes = all[t];
      std::copy_n(mesh.tets[t].begin(), 4, nodes.begin());
      std::sort(nodes.begin(), nodes.begin() + 4);
      for (std::size_t k = 0; k < edge.size(); ++k)
        nodes[4 + k] = edges.find(nodes[edge[k][0]], nodes[edge[k][1]]);
      volume[t] = volume_of(mesh, t);
    }
  });
  for (std::size_t t = 0; t < all.size(); ++t)
    for (std::size_t n = 0; n < nodes_per_element; ++n) {
      volume_[all[t][n]] += lumped_share(volume[t], n);
      shape_volume_[all[t][n]] += shape_share(volume[t], n);
    }
  if (dropped() == 0) {
    nodes_ = std::move(all);
    return;
  }
  for (const std::uint32_t t : corners_.source()) nodes_.push_back(all[t]);
}

std::vector<std::uint32_t> Tet10Elements::point_source() const {
  std::vector<std::uint32_t> out;
  out.reserve(points_per_element * size());
  for (const std::uint32_t t : corners_.source()) out.insert(out.end(), points_per_element, t);
  return out;
}

void Tet10Elements::follow(const TetMesh& mesh, const MeshEdit& edit) {
  corners_.follow(mesh, edit);
  edit.kept_tets.carry(nodes_);
  const std::vector<std::uint32_t> now = edit.kept_nodes.destinations();
  parallel_chunks(nodes_.size(), elements_per_chunk, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t e = first; e < last; ++e)
      for (std::uint32_t& node : nodes_[e]) node = now[node];  // undefined for elements that are set below
  });
  for (std::size_t i = 0; i < edit.tets.size(); ++i) {
    Nodes& nodes = nodes_[edit.tets[i]];
    std::copy_n(corners_.nodes(edit.tets[i]).begin(), 4, nodes.begin());
    std::copy_n(edit.middles.begin() + static_cast<std::ptrdiff_t>(6 * i), 6, nodes.begin() + 4);
  }
}

void Tet10Elements::follow_volume(const TetMesh& mesh, const MeshEdit& edit, const Connectivity& connectivity,
                                  const Incidence& incidence) {
  edit.kept_nodes.carry(volume_);
  edit.kept_nodes.carry(shape_volume_);
  for (const std::uint32_t node : edit.nodes) {
    double lumped = 0, by_shape = 0;  // in the order of the elements, as in the constructor
    for (const std::uint32_t corner : incidence.corners(node)) {
      const std::size_t e = connectivity.element_of(corner);
      const std::size_t n = corner - connectivity.first_corner(e);
      const double V = volume_of(mesh, e);
      lumped += lumped_share(V, n);
      by_shape += shape_share(V, n);
    }
    volume_[node] = lumped;
    shape_volume_[node] = by_shape;
  }
}

void Tet10Elements::move(std::size_t e, const double* x, double* to) const {
  std::array<Vec3, nodes_per_element> p;
  for (std::size_t n = 0; n < nodes_per_element; ++n)
    p[n] = Eigen::Map<const Vec3>(x + 3 * std::size_t{nodes_[e][n]});
  for (std::size_t q = 0; q < points_per_element; ++q) {
    std::array<Vec3, 4> D;
    for (Vec3& d : D) d.setZero();
    for (std::size_t n = 0; n < nodes_per_element; ++n) {
      const Tet10Share& s = tet10_shares[q][n];
      for (std::size_t k = 0; k < s.count; ++k) D[s.corner[k]] += s.weight[k] * p[n];
    }
    for (const Vec3& d : D) to = std::copy_n(d.data(), 3, to);
  }
}

void Tet10Elements::gather(const Tet4Elements::Forces* points, Vec3* f) {
  for (std::size_t n = 0; n < nodes_per_element; ++n) {
    f[n].setZero();
    for (std::size_t q = 0; q < points_per_element; ++q) {
      const Tet10Share& s = tet10_shares[q][n];
      for (std::size_t k = 0; k < s.count; ++k) f[n] += s.weight[k] * points[q][s.corner[k]];
    }
  }
}

void Tet10Elements::gather(const Tet4Elements::Stiffness* points, Mat3* K) {
  constexpr std::size_t pairs = Connectivity::pair_count(nodes_per_element);
  for (std::size_t k = 0; k < pairs; ++k) K[k].setZero();
  for (std::size_t q = 0; q < points_per_element; ++q) {
    std::array<std::array<Mat3, 4>, 4> full;
    for (std::size_t c = 0; c < 4; ++c) full[c][c].setZero();
    for (const auto& [a, b] : edge) {
      const Mat3& block = points[q][static_cast<std::size_t>(
          Tet4Elements::pair_index(static_cast<int>(a), static_cast<int>(b)))];
      full[a][b] = block;
      full[b][a] = block.transpose();
      full[a][a] -= full[a][b];
      full[b][b] -= full[b][a];
    }
    Mat3* to = K;
    for (std::size_t a = 0; a < nodes_per_element; ++a) {
      const Tet10Share& s = tet10_shares[q][a];
      for (std::size_t b = a + 1; b < nodes_per_element; ++b, ++to) {
        const Tet10Share& t = tet10_shares[q][b];
        for (std::size_t i = 0; i < s.count; ++i)
          for (std::size_t j = 0; j < t.count; ++j)
            *to += s.weight[i] * t.weight[j] * full[s.corner[i]][t.corner[j]];
      }
    }
  }
}

void Tet10Elements::spread(const CorotatedVector* corners, CorotatedVector* r) {
  for (std::size_t q = 0; q < points_per_element; ++q, corners += 4)
    for (std::size_t n = 0; n < nodes_per_element; ++n, ++r) {
      const Tet10Share& s = tet10_shares[q][n];
      const CorotatedVector &a = corners[s.corner[0]], &b = corners[s.corner[1]];
      const auto wa = static_cast<float>(s.weight[0]), wb = static_cast<float>(s.weight[1]);
      for (std::size_t k = 0; k < 4; ++k) r->at[k] = wa * a.at[k] + wb * b.at[k];
    }
}

}  // namespace prosector::soft
