#include "server/physics/mechanics/soft/elements/edge_nodes.h"

#include <algorithm>

#include "server/physics/base/parallel.h"

namespace prosector::soft {
namespace {

using Tet = std::array<std::uint32_t, 4>;

constexpr std::size_t vertices_per_chunk = 512, mesh_tets_per_chunk = 512;

/// Returns the eight tetrahedra between the nodes of a quadratic one. They depend on the order of its
/// corners.
std::array<Tet, 8> eighths(const Tet& tet, const EdgeNodes& edges) {
  std::array<Tet, 4> middle{};
  for (const auto& [a, b] : EdgeNodes::edges_of_tet) middle[a][b] = middle[b][a] = edges.find(tet[a], tet[b]);
  std::array<Tet, 8> out;
  for (std::size_t c = 0; c < 4; ++c)
    out[c] = {tet[c], middle[c][(c + 1) % 4], middle[c][(c + 2) % 4], middle[c][(c + 3) % 4]};
  const Tet ring = {middle[0][2], middle[1][2], middle[1][3], middle[0][3]};
  for (std::size_t k = 0; k < 4; ++k) out[4 + k] = {middle[0][1], middle[2][3], ring[k], ring[(k + 1) % 4]};
  return out;
}

/// Sets the node indices of zero weights to 0, so that equal rows compare equal.
SparseMap::Row without_unused(SparseMap::Row row) {
  for (std::size_t k = 0; k < 4; ++k)
    if (row.weight[k] == 0) row.node[k] = 0;
  return row;
}

}  // namespace

EdgeNodes::EdgeNodes(std::span<const Tet> tets, std::size_t vertices) : vertices_(vertices) {
  std::uint32_t end = 0;
  for (const auto& tet : tets) end = std::max(end, 1 + *std::max_element(tet.begin(), tet.end()));
  // Upper ends by lower end, once for each tetrahedron at the edge.
  std::vector<std::uint32_t> first(end + 1, 0);
  const auto for_edges = [&](const auto& f) {
    for (const auto& tet : tets)
      for (const auto& [a, b] : edges_of_tet) f(std::min(tet[a], tet[b]), std::max(tet[a], tet[b]));
  };
  for_edges([&](std::uint32_t lower, std::uint32_t) { ++first[lower + 1]; });
  for (std::uint32_t v = 0; v < end; ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> upper(first.back()), next(first.begin(), first.end() - 1);
  for_edges([&](std::uint32_t lower, std::uint32_t other) { upper[next[lower]++] = other; });
  parallel_chunks(end, vertices_per_chunk, [&](std::size_t begin, std::size_t last, std::size_t) {
    for (std::size_t v = begin; v < last; ++v)
      std::sort(upper.begin() + first[v], upper.begin() + first[v + 1]);
  });
  for (std::uint32_t v = 0; v < end; ++v)
    for (std::uint32_t k = first[v]; k < first[v + 1]; ++k) {
      if (k == first[v] || upper[k] != upper[k - 1]) {
        edges_.push_back({v, upper[k]});
        count_.push_back(0);
      }
      ++count_.back();
    }
  index_by_lower_end();
}

void EdgeNodes::index_by_lower_end() {
  begin_.assign(edges_.empty() ? 1 : edges_.back()[0] + 2, 0);
  for (const Edge& edge : edges_) ++begin_[edge[0] + 1];
  for (std::size_t v = 0; v + 1 < begin_.size(); ++v) begin_[v + 1] += begin_[v];
}

EdgeNodes EdgeNodes::of(const TetMesh& mesh) {
  EdgeNodes out(mesh.tets, 0);
  out.vertices_ = mesh.positions.size() - out.size();
  return out;
}

std::uint32_t EdgeNodes::find(std::uint32_t a, std::uint32_t b) const {
  const std::uint32_t lower = std::min(a, b), upper = std::max(a, b);
  if (lower + 1 >= begin_.size()) return none;
  for (std::uint32_t k = begin_[lower]; k < begin_[lower + 1]; ++k)
    if (edges_[k][1] == upper) return static_cast<std::uint32_t>(vertices_) + k;
  return none;
}

std::vector<std::uint32_t> EdgeNodes::let_go(const TetMesh& before, const MeshEdit& corners) {
  std::vector<std::uint32_t> met;
  const auto let_go_of = [&](const Tet& tet) {
    for (const auto& [a, b] : edges_of_tet) {
      met.push_back(find(tet[a], tet[b]) - static_cast<std::uint32_t>(vertices_));
      --count_[met.back()];
    }
  };
  auto changed = corners.tets.begin();
  std::uint32_t gone = 0;
  for (const Kept::Run& run : corners.kept_tets.runs) {
    while (gone < run.from) let_go_of(before.tets[gone++]);
    while (changed != corners.tets.end() && *changed < run.to) ++changed;  // skips new tetrahedra
    for (; changed != corners.tets.end() && *changed < run.to + run.count; ++changed)
      let_go_of(before.tets[run.from + (*changed - run.to)]);
    gone = run.from + run.count;
  }
  while (gone < corners.kept_tets.before) let_go_of(before.tets[gone++]);
  return met;
}

std::vector<EdgeNodes::Edge> EdgeNodes::take_up(const MeshEdit& corners, std::vector<std::uint32_t>& met) {
  const std::vector<std::uint32_t> origin = corners.kept_nodes.origins();
  std::vector<Edge> made;
  for (const Tet& tet : corners.corners)
    for (const auto& [i, j] : edges_of_tet) {
      const std::uint32_t a = std::min(tet[i], tet[j]), b = std::max(tet[i], tet[j]);
      const bool there = origin[a] != Kept::none && origin[b] != Kept::none;
      const std::uint32_t was = there ? find(origin[a], origin[b]) : none;
      if (was == none) {
        made.push_back({a, b});
      } else {
        met.push_back(was - static_cast<std::uint32_t>(vertices_));
        ++count_[met.back()];
      }
    }
  std::sort(made.begin(), made.end());
  return made;
}

EdgeNodes::Merged EdgeNodes::merge(const TetMesh& before, const MeshEdit& corners, std::span<const Edge> made,
                                   MeshEdit& out) const {
  const std::vector<std::uint32_t> origin = corners.kept_nodes.origins(),
                                   now = corners.kept_nodes.destinations();
  const auto position = [&](std::uint32_t vertex) -> const Vec3& {
    if (origin[vertex] != Kept::none) return before.positions[origin[vertex]];
    const auto at = std::lower_bound(corners.made_nodes.begin(), corners.made_nodes.end(), vertex);
    return corners.positions[static_cast<std::size_t>(at - corners.made_nodes.begin())];
  };
  const auto first_before = static_cast<std::uint32_t>(vertices_),
             first = static_cast<std::uint32_t>(corners.kept_nodes.now);
  Merged all;
  all.is_now.assign(edges_.size(), none);
  auto next = made.begin();
  const auto put_made = [&] {
    const Edge edge = *next;
    const auto end = std::find_if(next, made.end(), [&](const Edge& other) { return other != edge; });
    out.made_nodes.push_back(first + static_cast<std::uint32_t>(all.edges.size()));
    out.positions.emplace_back((position(edge[0]) + position(edge[1])) / 2);
    all.edges.push_back(edge);
    all.count.push_back(static_cast<std::uint32_t>(end - next));
    next = end;
  };
  out.kept_nodes.before += edges_.size();
  for (std::uint32_t k = 0; k < edges_.size(); ++k) {
    if (count_[k] == 0) continue;
    const Edge edge = {now[edges_[k][0]], now[edges_[k][1]]};
    while (next != made.end() && *next < edge) put_made();
    all.is_now[k] = first + static_cast<std::uint32_t>(all.edges.size());
    out.kept_nodes.add(first_before + k, all.is_now[k]);
    all.edges.push_back(edge);
    all.count.push_back(count_[k]);
  }
  while (next != made.end()) put_made();
  out.kept_nodes.now += all.edges.size();
  return all;
}

MeshEdit EdgeNodes::follow(const TetMesh& before, const MeshEdit& corners) {
  MeshEdit out = corners;
  std::vector<std::uint32_t> met = let_go(before, corners);
  const std::vector<Edge> made = take_up(corners, met);
  Merged all = merge(before, corners, made, out);

  std::vector<std::uint32_t> nodes(
      out.made_nodes.begin() + static_cast<std::ptrdiff_t>(corners.made_nodes.size()), out.made_nodes.end());
  for (const std::uint32_t k : met)
    if (all.is_now[k] != none) nodes.push_back(all.is_now[k]);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  out.nodes.insert(out.nodes.end(), nodes.begin(), nodes.end());

  vertices_ = corners.kept_nodes.now;
  edges_ = std::move(all.edges);
  count_ = std::move(all.count);
  index_by_lower_end();
  for (Tet tet : corners.corners) {
    std::sort(tet.begin(), tet.end());
    for (const auto& [a, b] : edges_of_tet) out.middles.push_back(find(tet[a], tet[b]));
  }
  return out;
}

EdgeNodes add_edge_nodes(Anatomy& anatomy) {
  std::vector<Vec3>& positions = anatomy.tets.positions;
  EdgeNodes edges(anatomy.tets.tets, positions.size());
  positions.reserve(positions.size() + edges.size());
  for (const auto& [a, b] : edges.edges()) positions.push_back((positions[a] + positions[b]) / 2);
  for (SparseMap::Row& row : anatomy.embedding.rows) row = divided(row, edges);
  return edges;
}

SparseMap::Row divided(const SparseMap::Row& row, const EdgeNodes& edges) {
  std::array<std::uint32_t, 4> node{};
  std::array<double, 4> L{};
  std::size_t n = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (row.weight[k] == 0) continue;
    node[n] = row.node[k];
    L[n++] = row.weight[k];
  }
  std::array<std::array<std::uint32_t, 4>, 4> middle{};
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      middle[a][b] = middle[b][a] = edges.find(node[a], node[b]);
      if (middle[a][b] == EdgeNodes::none) return row;
    }
  SparseMap::Row best;
  double best_least = -1e300;
  const auto consider = [&](const SparseMap::Row& part) {
    const double least =
        *std::min_element(part.weight.begin(), part.weight.begin() + static_cast<std::ptrdiff_t>(n));
    if (least > best_least) {
      best = part;
      best_least = least;
    }
  };
  for (std::size_t c = 0; c < n; ++c) {  // the part at a corner
    SparseMap::Row part;
    part.node[0] = node[c];
    part.weight[0] = 2 * L[c] - 1;
    for (std::size_t d = 0, at = 1; d < n; ++d) {
      if (d == c) continue;
      part.node[at] = middle[c][d];
      part.weight[at++] = 2 * L[d];
    }
    consider(part);
  }
  if (n == 3)
    consider({{middle[1][2], middle[0][2], middle[0][1]}, {1 - 2 * L[0], 1 - 2 * L[1], 1 - 2 * L[2]}});
  if (n < 4) return without_unused(best);
  // Parts around the diagonal from the midpoint of edge 0 1 to that of edge 2 3.
  for (std::size_t s = 0; s < 4; ++s) {
    const std::size_t t = s ^ 1, p = s < 2 ? 2 : 0, q = p + 1;
    consider({{middle[s][t], middle[p][q], middle[s][p], middle[s][q]},
              {2 * L[t], L[p] + L[q] - L[s] + L[t], L[p] - L[q] + L[s] - L[t], L[q] - L[p] + L[s] - L[t]}});
  }
  return without_unused(best);
}

TetMesh divided(const TetMesh& mesh, const EdgeNodes& edges) {
  TetMesh out{mesh.positions, std::vector<Tet>(8 * mesh.tets.size()), mesh.stretch};
  parallel_chunks(mesh.tets.size(), mesh_tets_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t t = first; t < last; ++t)
                      std::ranges::copy(eighths(mesh.tets[t], edges),
                                        out.tets.begin() + static_cast<std::ptrdiff_t>(8 * t));
                  });
  return out;
}

void follow_divided(const TetMesh& mesh, const EdgeNodes& edges, const MeshEdit& edit, TetMesh& parts) {
  parts.positions = mesh.positions;
  edit.kept_tets.carry(parts.tets, 8);
  const std::vector<std::uint32_t> now = edit.kept_nodes.destinations();
  parallel_chunks(parts.tets.size(), 8 * mesh_tets_per_chunk,
                  [&](std::size_t first, std::size_t last, std::size_t) {
                    for (std::size_t t = first; t < last; ++t)
                      for (std::uint32_t& corner : parts.tets[t]) corner = now[corner];
                  });
  for (const std::uint32_t t : edit.tets)
    std::ranges::copy(eighths(mesh.tets[t], edges), parts.tets.begin() + 8 * std::ptrdiff_t{t});
}

}  // namespace prosector::soft
