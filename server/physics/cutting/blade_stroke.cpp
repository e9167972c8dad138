#include "server/physics/cutting/blade_stroke.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"
#include "server/physics/cutting/tet_tree.h"

namespace prosector {
namespace {

// Not finite where the tetrahedron is flat.
Eigen::Vector4d weights_in(const TetComplex& complex, TetId tet, std::span<const Vec3> positions,
                           const Vec3& x) {
  const auto& c = complex.corners(tet);
  Mat3 edges;
  for (int k = 0; k < 3; ++k) edges.col(k) = positions[c[static_cast<std::size_t>(k) + 1]] - positions[c[0]];
  const Vec3 w = edges.inverse() * (x - positions[c[0]]);
  return {1 - w.sum(), w[0], w[1], w[2]};
}

}  // namespace

void check_edge(std::span<const Vec3> edge) {
  if (edge.size() < 2)
    throw InputError(fmt::format("blade: its edge has {} points; allowed: 2 or more", edge.size()));
  for (std::size_t i = 0; i < edge.size(); ++i)
    if (!is_finite(edge[i]))
      throw InputError(fmt::format("blade: point {} of its edge is not finite; allowed: finite, in m", i));
}

BladeStroke begin_stroke(std::span<const Vec3> edge) {
  check_edge(edge);
  BladeStroke stroke;
  for (const Vec3& x : edge) stroke.edge.push_back({.room = x});
  return stroke;
}

std::vector<Vec3> carried_edge(const BladeStroke& stroke, const TetComplex& complex,
                               std::span<const Vec3> positions) {
  std::vector<Vec3> out;
  out.reserve(stroke.edge.size());
  for (const BladeStroke::EdgePoint& p : stroke.edge) {
    if (!complex.has_tet(p.tet)) {
      out.push_back(p.room);
      continue;
    }
    Vec3 x = Vec3::Zero();
    for (std::size_t k = 0; k < 4; ++k) x += p.weight[k] * positions[complex.corners(p.tet)[k]];
    out.push_back(x);
  }
  return out;
}

void hold_edge(BladeStroke& stroke, std::span<const Vec3> edge, const TetComplex& complex,
               const TetTree& tree, std::span<const Vec3> positions) {
  stroke.edge.assign(edge.size(), {});
  std::vector<TetId> near;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    BladeStroke::EdgePoint& point = stroke.edge[i];
    point.room = edge[i];
    if (complex.is_sheet()) continue;
    near.clear();
    tree.query(edge[i], near);
    for (std::size_t n = 0; n < near.size(); ++n)
      if (!complex.has_tet(near[n])) {
        near.push_back(complex.child(near[n]));
        near.push_back(near.back() + 1);
      }
    std::sort(near.begin(), near.end());
    for (const TetId t : near) {
      if (!complex.has_tet(t)) continue;
      const Eigen::Vector4d w = weights_in(complex, t, positions, edge[i]);
      if (!w.allFinite() || w.minCoeff() < 0) continue;
      point.tet = t;
      for (std::size_t k = 0; k < 4; ++k) point.weight[k] = w[static_cast<int>(k)];
      break;
    }
  }
}

}  // namespace prosector
