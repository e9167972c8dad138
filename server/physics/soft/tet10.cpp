#include "server/physics/soft/tet10.h"

#include <algorithm>

#include "server/physics/soft/connectivity.h"

namespace prosector {
namespace {

/// The four-point rule exact for quadratic fields (Hammer, Marlowe, Stroud 1956): (5 ± √5 …)/20.
constexpr double near = 0.58541019662496845446, far = 0.13819660112501051518;
constexpr double barycentric(std::size_t point, std::size_t corner) {
  return point == corner ? near : far;
}

/// Column n of T_q: the corners c whose D_c node n moves, and by how much.
struct Share {
  std::size_t count;
  std::array<std::size_t, 2> corner;
  std::array<double, 2> weight;
};
constexpr Share share(std::size_t point, std::size_t node) {
  if (node < 4) return {1, {node, node}, {4 * barycentric(point, node) - 1, 0}};
  const auto [c, d] = Tet10Elements::edge[node - 4];
  return {2, {c, d}, {4 * barycentric(point, d), 4 * barycentric(point, c)}};
}
constexpr auto make_shares() {
  std::array<std::array<Share, 10>, 4> all{};
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t n = 0; n < 10; ++n) all[q][n] = share(q, n);
  return all;
}
constexpr auto shares = make_shares();

using Edge = std::array<std::uint32_t, 2>;

/// Of all tetrahedra, ascending.
std::vector<Edge> edges_of(const TetMesh& mesh) {
  std::vector<Edge> edges;
  for (std::array<std::uint32_t, 4> tet : mesh.tets) {
    std::sort(tet.begin(), tet.end());
    for (const auto& [a, b] : Tet10Elements::edge) edges.push_back({tet[a], tet[b]});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

/// Edges as nodes after the vertices.
class EdgeNodes {
 public:
  EdgeNodes(std::vector<Edge> edges, std::size_t first)
      : edges_(std::move(edges)), first_(static_cast<std::uint32_t>(first)) {}
  /// False when no tetrahedron has that edge.
  bool find(std::uint32_t a, std::uint32_t b, std::uint32_t& node) const {
    const Edge edge = {std::min(a, b), std::max(a, b)};
    const auto at = std::lower_bound(edges_.begin(), edges_.end(), edge);
    if (at == edges_.end() || *at != edge) return false;
    node = first_ + static_cast<std::uint32_t>(at - edges_.begin());
    return true;
  }

 private:
  std::vector<Edge> edges_;
  std::uint32_t first_;
};

/// The best of the eight: whose least weight is largest.
SparseMap::Row divided(const SparseMap::Row& linear, const EdgeNodes& edges) {
  const auto& [node, L] = linear;
  std::array<std::array<std::uint32_t, 4>, 4> middle{};
  for (const auto& [a, b] : Tet10Elements::edge) {
    if (!edges.find(node[a], node[b], middle[a][b])) return linear;  // fewer than four nodes
    middle[b][a] = middle[a][b];
  }
  SparseMap::Row best = linear;
  double best_least = -1e300;
  const auto consider = [&](const SparseMap::Row& row) {
    const double least = *std::min_element(row.weight.begin(), row.weight.end());
    if (least > best_least) {
      best = row;
      best_least = least;
    }
  };
  for (std::size_t c = 0; c < 4; ++c) {  // at a vertex
    SparseMap::Row row;
    row.node[0] = node[c];
    row.weight[0] = 2 * L[c] - 1;
    for (std::size_t d = 0, at = 1; d < 4; ++d) {
      if (d == c) continue;
      row.node[at] = middle[c][d];
      row.weight[at++] = 2 * L[d];
    }
    consider(row);
  }
  for (std::size_t s = 0; s < 4; ++s) {  // around the diagonal from the middle of 0 1 to that of 2 3
    const std::size_t t = s ^ 1, p = s < 2 ? 2 : 0, q = p + 1;
    consider({{middle[s][t], middle[p][q], middle[s][p], middle[s][q]},
              {2 * L[t], L[p] + L[q] - L[s] + L[t], L[p] - L[q] + L[s] - L[t], L[q] - L[p] + L[s] - L[t]}});
  }
  return best;
}

}  // namespace

Tet10Elements::Tet10Elements(const TetMesh& mesh) {
  std::vector<Edge> edges = edges_of(mesh);
  const std::size_t vertices = mesh.positions.size() - edges.size();
  const EdgeNodes edge_nodes(std::move(edges), vertices);
  const Tet4Elements corners(mesh);
  dropped_ = corners.dropped();
  for (std::size_t e = 0; e < corners.size(); ++e) {
    Nodes nodes{};
    std::copy_n(corners.nodes(e).begin(), 4, nodes.begin());
    for (std::size_t k = 0; k < edge.size(); ++k)
      edge_nodes.find(nodes[edge[k][0]], nodes[edge[k][1]], nodes[4 + k]);
    nodes_.push_back(nodes);
    for (std::size_t q = 0; q < points_per_element; ++q) {
      std::array<std::uint32_t, 4> own{};
      for (std::size_t c = 0; c < 4; ++c) {
        own[c] = static_cast<std::uint32_t>(points_.positions.size());
        points_.positions.push_back(mesh.positions[nodes[c]]);
      }
      points_.tets.push_back(own);
      point_source_.push_back(corners.source()[e]);
    }
  }
  volume_ = VecX::Zero(static_cast<Eigen::Index>(mesh.positions.size()));
  for (const auto& tet : mesh.tets) {
    const Vec3& x = mesh.positions[tet[0]];
    const double V =
        std::abs(
            (mesh.positions[tet[1]] - x).cross(mesh.positions[tet[2]] - x).dot(mesh.positions[tet[3]] - x)) /
        6;
    for (std::uint32_t vertex : tet) volume_[vertex] += V / 36;
    for (const auto& [a, b] : edge) {
      std::uint32_t node = 0;
      edge_nodes.find(tet[a], tet[b], node);
      volume_[node] += 4 * V / 27;
    }
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
      const Share& s = shares[q][n];
      for (std::size_t k = 0; k < s.count; ++k) D[s.corner[k]] += s.weight[k] * p[n];
    }
    for (const Vec3& d : D) to = std::copy_n(d.data(), 3, to);
  }
}

void Tet10Elements::gather(const Tet4Elements::Forces* points, Vec3* f) {
  for (std::size_t n = 0; n < nodes_per_element; ++n) {
    f[n].setZero();
    for (std::size_t q = 0; q < points_per_element; ++q) {
      const Share& s = shares[q][n];
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
      const Share& s = shares[q][a];
      for (std::size_t b = a + 1; b < nodes_per_element; ++b, ++to) {
        const Share& t = shares[q][b];
        for (std::size_t i = 0; i < s.count; ++i)
          for (std::size_t j = 0; j < t.count; ++j)
            *to += s.weight[i] * t.weight[j] * full[s.corner[i]][t.corner[j]];
      }
    }
  }
}

void Tet10Elements::spread(const TurnedVector* corners, TurnedVector* r) {
  for (std::size_t q = 0; q < points_per_element; ++q, corners += 4)
    for (std::size_t n = 0; n < nodes_per_element; ++n, ++r) {
      const Share& s = shares[q][n];
      const TurnedVector &a = corners[s.corner[0]], &b = corners[s.corner[1]];
      const auto wa = static_cast<float>(s.weight[0]), wb = static_cast<float>(s.weight[1]);
      for (std::size_t k = 0; k < 4; ++k) r->at[k] = wa * a.at[k] + wb * b.at[k];
    }
}

void add_edge_nodes(Anatomy& anatomy) {
  std::vector<Edge> edges = edges_of(anatomy.tets);
  const std::size_t vertices = anatomy.tets.positions.size();
  for (const auto& [a, b] : edges) {
    const Vec3 middle = (anatomy.tets.positions[a] + anatomy.tets.positions[b]) / 2;
    anatomy.tets.positions.push_back(middle);
  }
  const EdgeNodes edge_nodes(std::move(edges), vertices);
  for (SparseMap::Row& row : anatomy.embedding.rows) row = divided(row, edge_nodes);
}

TetMesh divided(const TetMesh& mesh) {
  std::vector<Edge> edges = edges_of(mesh);
  const std::size_t vertices = mesh.positions.size() - edges.size();
  const EdgeNodes edge_nodes(std::move(edges), vertices);
  TetMesh out{mesh.positions, {}};
  out.tets.reserve(8 * mesh.tets.size());
  for (const auto& tet : mesh.tets) {
    std::array<std::array<std::uint32_t, 4>, 4> middle{};
    for (const auto& [a, b] : Tet10Elements::edge) {
      edge_nodes.find(tet[a], tet[b], middle[a][b]);
      middle[b][a] = middle[a][b];
    }
    for (std::size_t c = 0; c < 4; ++c)
      out.tets.push_back({tet[c], middle[c][(c + 1) % 4], middle[c][(c + 2) % 4], middle[c][(c + 3) % 4]});
    const std::array<std::uint32_t, 4> ring = {middle[0][2], middle[1][2], middle[1][3], middle[0][3]};
    for (std::size_t k = 0; k < 4; ++k)
      out.tets.push_back({middle[0][1], middle[2][3], ring[k], ring[(k + 1) % 4]});
  }
  return out;
}

}  // namespace prosector
