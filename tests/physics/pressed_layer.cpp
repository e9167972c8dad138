#include "tests/physics/pressed_layer.h"

#include <cmath>
#include <map>

#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

/// 0, cell, 2·cell … up to `core`, then each wider than the last by `growth`, up to `end`.
std::vector<double> graded(double cell, double core, double end, double growth) {
  std::vector<double> x = {0};
  while (x.back() < core - cell / 2) x.push_back(x.back() + cell);
  const std::size_t outer = x.size();
  for (double step = cell; x.back() < end;) x.push_back(x.back() + (step *= growth));
  const double from = x[outer - 1], stretch = (end - from) / (x.back() - from);
  for (std::size_t i = outer; i < x.size(); ++i) x[i] = from + (x[i] - from) * stretch;
  return x;
}

using Node = std::uint32_t;
using Edge = std::pair<Node, Node>;

/// A tetrahedron of each edge.
std::map<Edge, std::size_t> tets_by_edge(const TetMesh& mesh) {
  std::map<Edge, std::size_t> out;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Node a : mesh.tets[t])
      for (const Node b : mesh.tets[t])
        if (a < b) out.emplace(Edge(a, b), t);
  return out;
}

/// A point half-way between two nodes of a tetrahedron.
SparseMap::Row middle(const std::array<Node, 4>& tet, Node a, Node b) {
  SparseMap::Row row{tet, {}};
  for (std::size_t k = 0; k < 4; ++k) row.weight[k] = tet[k] == a || tet[k] == b ? 0.5 : 0;
  return row;
}

}  // namespace

Anatomy pressed_layer(double height, double core, double cell, double growth) {
  const auto across = graded(cell, core, 3 * height, growth), down = graded(cell, core, height, growth);
  const int n = static_cast<int>(across.size()) - 1, m = static_cast<int>(down.size()) - 1;
  Anatomy out = make_block(Vec3(2 * n, m, 2 * n), {2 * n, m, 2 * n});
  const auto place = [&](Vec3& x) {
    const auto sideways = [&](double i) {
      return std::copysign(across[static_cast<std::size_t>(std::lround(std::abs(i)))], i);
    };
    x = {sideways(x.x()), -down[static_cast<std::size_t>(std::lround(m / 2.0 - x.y()))], sideways(x.z())};
  };
  for (Vec3& x : out.tets.positions) place(x);
  for (Vec3& x : out.surface.positions) place(x);
  return out;
}

Anatomy even_layer(double width, double height, double cell) {
  const auto cells = [&](double size) { return static_cast<int>(std::lround(size / cell)); };
  Anatomy out = make_block({width, height, width}, {cells(width), cells(height), cells(width)});
  for (auto* points : {&out.tets.positions, &out.surface.positions})
    for (Vec3& x : *points) x.y() -= height / 2;
  return out;
}

void halve_surface(Anatomy& anatomy) {
  TriangleMesh& surface = anatomy.surface;
  auto& rows = anatomy.embedding.rows;
  const auto tets = tets_by_edge(anatomy.tets);
  std::map<Edge, Node> middles;  // of surface vertices
  const auto middle_of = [&](Node a, Node b) {
    const auto [at, fresh] = middles.emplace(std::minmax(a, b), static_cast<Node>(rows.size()));
    if (fresh) {
      const Edge nodes = std::minmax(rows[a].node[0], rows[b].node[0]);
      surface.positions.push_back((surface.positions[a] + surface.positions[b]) / 2);
      rows.push_back(middle(anatomy.tets.tets[tets.at(nodes)], nodes.first, nodes.second));
    }
    return at->second;
  };
  std::vector<std::array<Node, 3>> halves;
  for (const auto& [a, b, c] : surface.triangles) {
    const Node ab = middle_of(a, b), bc = middle_of(b, c), ca = middle_of(c, a);
    for (const std::array<Node, 3>& t :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      halves.push_back(t);
  }
  surface.triangles = std::move(halves);
}

}  // namespace prosector::test
