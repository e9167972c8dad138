#pragma once
// The constant matrices T_q of quadratic tetrahedra (tet10.h): how the corners D_c that represent integration
// point q depend on the ten nodes.

#include <array>
#include <cstddef>

#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector::soft {

/// Column n of T_q: the corners c whose D_c depends on node n, and the weights. A vertex has one corner; its
/// second weight is 0.
struct Tet10Share {
  std::size_t count;
  std::array<std::size_t, 2> corner;
  std::array<double, 2> weight;
};

/// Returns the barycentric coordinate of a corner at an integration point of the four-point rule that is
/// exact for quadratic fields: (5 ± √5 …)/20 (Hammer, Marlowe, Stroud 1956).
constexpr double tet10_barycentric(std::size_t point, std::size_t corner) {
  return point == corner ? 0.58541019662496845446 : 0.13819660112501051518;
}
constexpr Tet10Share tet10_share(std::size_t point, std::size_t node) {
  if (node < 4) return {1, {node, node}, {4 * tet10_barycentric(point, node) - 1, 0}};
  const auto [c, d] = EdgeNodes::edges_of_tet[node - 4];
  return {2, {c, d}, {4 * tet10_barycentric(point, d), 4 * tet10_barycentric(point, c)}};
}
constexpr auto make_tet10_shares() {
  std::array<std::array<Tet10Share, 10>, 4> all{};
  for (std::size_t q = 0; q < 4; ++q)
    for (std::size_t n = 0; n < 10; ++n) all[q][n] = tet10_share(q, n);
  return all;
}
inline constexpr auto tet10_shares = make_tet10_shares();  // by point and node

}  // namespace prosector::soft
