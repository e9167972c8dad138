#pragma once
// Soft bodies that change as cuts change them, without any mechanics: triangles split, vertices double,
// things go and come back, and the anatomy stays compact with numbers that are kept.

#include <algorithm>
#include <random>

#include "server/session/sending/topology_log.h"

namespace prosector::test {

struct CutBody {
  Anatomy anatomy;
  Numbering numbering;
  VecX x;
  TopologyChange change;
  std::uint32_t next_node = 0, next_vertex = 0, next_triangle = 0;

  CutBody() = default;
  CutBody(Anatomy whole, BodyId body) : anatomy(std::move(whole)) {
    const auto count = [](std::vector<std::uint32_t>& numbers, std::size_t n) {
      for (std::size_t i = 0; i < n; ++i) numbers.push_back(static_cast<std::uint32_t>(i));
      return static_cast<std::uint32_t>(n);
    };
    next_node = count(numbering.nodes, anatomy.tets.positions.size());
    next_vertex = count(numbering.vertices, anatomy.surface.positions.size());
    next_triangle = count(numbering.triangles, anatomy.surface.triangles.size());
    change.body = body;
    change.cause = TopologyCause::compiled;
    move(0);
  }

  /// All nodes to where they are at `time`, s.
  void move(double time) {
    x.resize(3 * static_cast<Eigen::Index>(anatomy.tets.positions.size()));
    for (std::size_t i = 0; i < anatomy.tets.positions.size(); ++i) {
      const Vec3& rest = anatomy.tets.positions[i];
      x.segment<3>(3 * static_cast<Eigen::Index>(i)) =
          rest + 0.01 * Vec3(std::sin(3 * time + 20 * rest.y()), std::cos(2 * time + 9 * rest.x()), time);
    }
  }

  std::uint32_t new_node(const Vec3& rest) {
    anatomy.tets.positions.push_back(rest);
    numbering.nodes.push_back(next_node++);
    return static_cast<std::uint32_t>(anatomy.tets.positions.size() - 1);
  }
  std::uint32_t new_vertex(const SparseMap::Row& row, const Vec3& rest) {
    anatomy.surface.positions.push_back(rest);
    anatomy.embedding.rows.push_back(row);
    numbering.vertices.push_back(next_vertex++);
    return static_cast<std::uint32_t>(anatomy.surface.positions.size() - 1);
  }
  void new_triangle(const std::array<std::uint32_t, 3>& corners) {
    anatomy.surface.triangles.push_back(corners);
    anatomy.surface.inner.push_back(1);
    numbering.triangles.push_back(next_triangle++);
  }
  void remove_triangle(std::size_t t) {
    const auto at = static_cast<std::ptrdiff_t>(t);
    anatomy.surface.triangles.erase(anatomy.surface.triangles.begin() + at);
    anatomy.surface.inner.erase(anatomy.surface.inner.begin() + at);
    numbering.triangles.erase(numbering.triangles.begin() + at);
  }

  /// A triangle becomes two about a new node in the middle of an edge; another one's corner gets a vertex of
  /// its own, on a node of its own; now and then one is lost with what only it used.
  void cut(std::mt19937_64& random, double time) {
    TriangleMesh& surface = anatomy.surface;
    surface.inner.resize(surface.triangles.size(), 0);
    const auto any = [&](std::size_t n) { return static_cast<std::uint32_t>(random() % n); };
    const auto [a, b, c] = surface.triangles[any(surface.triangles.size())];
    const Vec3 middle = 0.5 * (surface.positions[a] + surface.positions[b]);
    const std::uint32_t m = new_vertex({{new_node(middle)}, {1}}, middle);
    const auto split = std::ranges::find(surface.triangles, std::array{a, b, c}) - surface.triangles.begin();
    remove_triangle(static_cast<std::size_t>(split));
    new_triangle({a, m, c});
    new_triangle({m, b, c});
    auto& parted = surface.triangles[any(surface.triangles.size())];
    const Vec3 rest = surface.positions[parted[0]];
    parted[0] = new_vertex({{new_node(rest)}, {1}}, rest);
    if (random() % 3 == 0) {
      remove_triangle(any(surface.triangles.size()));
      compact();
    }
    move(time);
    ++change.revision;
    change.content_hash = random();
    change.cause = TopologyCause::cut;
  }

  /// As a body that has become nothing.
  void vanish() {
    while (!anatomy.surface.triangles.empty()) remove_triangle(0);
    compact();
    ++change.revision;
    move(0);
  }

  /// Without vertices that no triangle has, and nodes that no vertex hangs on.
  void compact() {
    std::vector<bool> vertex_used(anatomy.surface.positions.size()), node_used(anatomy.tets.positions.size());
    for (const auto& t : anatomy.surface.triangles)
      for (const auto v : t) vertex_used[v] = true;
    const auto vertex_of = keep(vertex_used, numbering.vertices, anatomy.surface.positions);
    std::vector<SparseMap::Row> rows;
    for (std::size_t v = 0; v < vertex_used.size(); ++v)
      if (vertex_used[v]) rows.push_back(anatomy.embedding.rows[v]);
    anatomy.embedding.rows = std::move(rows);
    for (auto& t : anatomy.surface.triangles)
      for (auto& v : t) v = vertex_of[v];
    for (const auto& row : anatomy.embedding.rows)
      for (std::size_t k = 0; k < 4; ++k)
        if (row.weight[k] != 0) node_used[row.node[k]] = true;
    const auto node_of = keep(node_used, numbering.nodes, anatomy.tets.positions);
    for (auto& row : anatomy.embedding.rows)
      for (std::size_t k = 0; k < 4; ++k) row.node[k] = row.weight[k] != 0 ? node_of[row.node[k]] : 0;
  }
  static std::vector<std::uint32_t> keep(const std::vector<bool>& used, std::vector<std::uint32_t>& numbers,
                                         std::vector<Vec3>& places) {
    std::vector<std::uint32_t> index(used.size()), kept_numbers;
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < used.size(); ++i) {
      index[i] = static_cast<std::uint32_t>(kept.size());
      if (!used[i]) continue;
      kept.push_back(places[i]);
      kept_numbers.push_back(numbers[i]);
    }
    places = std::move(kept);
    numbers = std::move(kept_numbers);
    return index;
  }
};

using Facets = std::vector<std::array<Eigen::Vector3f, 3>>;

/// The triangles that are there, as points of the room. In the order of their numbers, on server and client.
template <class Place>
Facets facets(const std::vector<std::array<std::uint32_t, 3>>& triangles, const Place& place) {
  Facets out;
  for (const auto& t : triangles)
    if (t[0] != t[1] || t[1] != t[2]) out.push_back({place(t[0]), place(t[1]), place(t[2])});
  return out;
}

inline Facets facets_of(const CutBody& body) {
  return facets(body.anatomy.surface.triangles, [&](std::uint32_t v) -> Eigen::Vector3f {
    return body.anatomy.embedding.apply(v, body.x.data()).cast<float>();
  });
}

inline float largest_difference(const Facets& a, const Facets& b) {
  if (a.size() != b.size()) return 1e9f;
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) most = std::max(most, (a[i][k] - b[i][k]).norm());
  return most;
}

}  // namespace prosector::test
