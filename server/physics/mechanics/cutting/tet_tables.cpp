#include "server/physics/mechanics/cutting/tet_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/anatomy/mesh_quality.h"
#include "common/assert.h"
#include "common/error.h"

namespace prosector::cutting {
namespace {

void fill_stars(TetTables& tables) {
  std::vector<std::size_t> around(tables.rest.size(), 0);
  for (TetId t = 0; t < tables.tet.size(); ++t)
    for (const NodeId node : tables.corners(t)) {
      if (node >= tables.rest.size())
        throw InputError(fmt::format(
            "cutting: tetrahedron {} refers to node {}, but the mesh has {} nodes, numbered from 0", t, node,
            tables.rest.size()));
      ++around[node];
    }
  // Reserves room for tetrahedra added by cuts.
  for (NodeId node = 0; node < tables.star.size(); ++node)
    tables.star[node].reserve(around[node] + around[node] / 2);
  for (TetId t = 0; t < tables.tet.size(); ++t)
    for (const NodeId node : tables.corners(t)) tables.star[node].push_back(t);
}

void fill_volumes(TetTables& tables) {
  for (TetId t = 0; t < tables.tet.size(); ++t) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < tables.sides; ++k) x[k] = tables.rest[tables.tet[t].corner[k]];
    TetTables::Tet& tet = tables.tet[t];
    tet.volume = tables.volume_of(std::span(x).first(tables.sides));
    if (!(tet.volume > 0))
      throw InputError(fmt::format("cutting: tetrahedron {} has a rest volume of {} m³; allowed: positive", t,
                                   tet.volume));
  }
}

void fill_mean_size(TetTables& tables) {
  double volume = 0;
  for (const TetTables::Tet& tet : tables.tet) volume += tet.volume;
  if (tables.live_tets > 0) tables.mean_volume = volume / static_cast<double>(tables.live_tets);
  tables.cell = tables.is_sheet() ? std::sqrt(4 / std::sqrt(3.0) * tables.mean_volume / tables.thickness)
                                  : std::cbrt(6 * std::sqrt(2.0) * tables.mean_volume);
}

/// Returns the nodes of a tetrahedron's face k, ascending.
std::array<NodeId, 3> sorted_face(const TetTables& tables, TetId t, std::size_t k) {
  const TetTables::Corners& c = tables.tet[t].corner;
  const auto& face = TetTables::face[k];
  std::array<NodeId, 3> key = {c[face[0]], c[face[1]], c[face[2]]};
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  if (key[1] > key[2]) std::swap(key[1], key[2]);
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  return key;
}

// Sorts faces into rows by their lowest node. A row has a few dozen entries and is searched linearly.
void join_by_faces(TetTables& tables) {
  struct Side {
    std::uint64_t others;  // the two other nodes
    TetId tet, joined;     // joined: the second tetrahedron with this face
    std::uint32_t k;
  };
  std::vector<std::uint32_t> begin(tables.rest.size() + 1, 0);
  for (TetId t = 0; t < tables.tet.size(); ++t)
    for (std::size_t k = 0; k < tables.sides; ++k) ++begin[sorted_face(tables, t, k)[0] + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  std::vector<Side> sides(begin.back());
  for (TetId t = 0; t < tables.tet.size(); ++t)
    for (std::uint32_t k = 0; k < tables.sides; ++k) {
      const auto [lowest, middle, highest] = sorted_face(tables, t, k);
      const std::uint64_t others = std::uint64_t{middle} << 32 | highest;
      Side* const last = sides.data() + end[lowest];
      Side* const same = std::find_if(sides.data() + begin[lowest], last,
                                      [&](const Side& side) { return side.others == others; });
      if (same == last) {
        *last = {others, t, TetTables::none, k};
        ++end[lowest];
        continue;
      }
      if (same->joined != TetTables::none)
        throw InputError(
            fmt::format("cutting: tetrahedra {}, {} and {} have one face in common; allowed: at most two "
                        "tetrahedra at each face",
                        same->tet, same->joined, t));
      same->joined = t;
      tables.tet[t].beyond[k] = same->tet;
      tables.tet[same->tet].beyond[same->k] = t;
    }
}

}  // namespace

TetTables tables_of(const TetMesh& rest) {
  TetTables out;
  out.grow_nodes(rest.positions.size());
  out.grow_tets(rest.tets.size());
  out.rest = rest.positions;
  for (std::size_t i = 0; i < rest.tets.size(); ++i) out.tet[i].corner = rest.tets[i];
  return out;
}

TetTables tables_of_sheet(const Anatomy& sheet) {
  TetTables out;
  out.sides = 3;
  out.thickness = sheet.thickness;
  out.grow_nodes(sheet.tets.positions.size());
  out.grow_tets(2 * sheet.quads.size());
  out.rest = sheet.tets.positions;
  for (std::size_t i = 0; i < sheet.quads.size(); ++i) {
    const auto& [a, b, c, d] = sheet.quads[i];
    out.tet[2 * i].corner = {a, b, c, TetTables::none};
    out.tet[2 * i + 1].corner = {a, c, d, TetTables::none};
  }
  return out;
}

void connect(TetTables& tables) {
  PROSECTOR_ASSERT(tables.sides == 3 || tables.sides == 4);
  PROSECTOR_ASSERT(tables.origin.size() == tables.rest.size() && tables.star.size() == tables.rest.size() &&
                   tables.node_live.size() == tables.rest.size());
  std::fill(tables.node_live.begin(), tables.node_live.end(), std::uint8_t{1});
  for (NodeId node = 0; node < tables.rest.size(); ++node) tables.origin[node] = {node, node, 0};
  tables.live_nodes = tables.rest.size();
  tables.live_tets = tables.tet.size();
  for (TetId t = 0; t < tables.tet.size(); ++t) {
    tables.tet[t].live = true;
    tables.tet[t].lineage.place = t;
  }
  fill_stars(tables);
  fill_volumes(tables);
  fill_mean_size(tables);
  join_by_faces(tables);
}

std::size_t TetTables::corner_index(TetId t, NodeId node) const {
  PROSECTOR_ASSERT(t < tet.size());
  const Corners& c = tet[t].corner;
  for (std::size_t k = 0; k < sides; ++k)
    if (c[k] == node) return k;
  return 4;
}

std::size_t TetTables::face_towards(TetId t, TetId other) const {
  PROSECTOR_ASSERT(t < tet.size() && other < tet.size());
  for (std::size_t k = 0; k < 4; ++k)
    if (tet[t].beyond[k] == other) return k;
  return 4;
}

std::size_t TetTables::face_shared(TetId t, TetId other) const {
  PROSECTOR_ASSERT(t < tet.size() && other < tet.size());
  std::size_t slot = 4, apart = 0;
  for (std::size_t k = 0; k < sides; ++k)
    if (corner_index(other, tet[t].corner[k]) == 4) {
      slot = k;
      ++apart;
    }
  return apart == 1 ? slot : 4;
}

void TetTables::around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const {
  PROSECTOR_ASSERT(a < star.size() && b < star.size());
  tets.clear();
  const TetId *i = star[a].data(), *j = star[b].data();
  const TetId *const last_i = i + star[a].size(), *const last_j = j + star[b].size();
  while (i != last_i && j != last_j) {
    const TetId of_a = *i, of_b = *j;
    if (of_a == of_b) tets.push_back(of_a);
    i += of_a <= of_b;
    j += of_b <= of_a;
  }
}

double TetTables::volume_of(std::span<const Vec3> x) const {
  PROSECTOR_ASSERT(x.size() == sides);
  if (is_sheet()) return thickness * (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  return tet_volume(x[0], x[1], x[2], x[3]);
}

void TetTables::grow_nodes(std::size_t end) {
  PROSECTOR_ASSERT(origin.size() == rest.size() && node_live.size() == rest.size() &&
                   star.size() == rest.size());
  if (end <= rest.size()) return;
  rest.resize(end, Vec3::Zero());
  origin.resize(end);
  node_live.resize(end, 0);
  star.resize(end);
}

void TetTables::grow_tets(std::size_t end) {
  if (end > tet.size()) tet.resize(end);
}

void TetTables::leave(NodeId node, TetId t) {
  PROSECTOR_ASSERT(node < star.size() && std::ranges::binary_search(star[node], t));
  auto& of = star[node];
  of.erase(std::lower_bound(of.begin(), of.end(), t));
}

void TetTables::leave_all(NodeId node, std::span<const TetId> tets) {
  PROSECTOR_ASSERT(node < star.size() && is_ascending(tets) && is_ascending(star[node]));
  auto next = tets.begin();
  std::erase_if(star[node], [&](TetId t) {
    const bool leaves = next != tets.end() && *next == t;
    next += leaves;
    return leaves;
  });
}

void TetTables::enter(NodeId node, TetId t) {
  PROSECTOR_ASSERT(node < star.size() && !std::ranges::binary_search(star[node], t));
  auto& of = star[node];
  of.insert(std::lower_bound(of.begin(), of.end(), t), t);
}

}  // namespace prosector::cutting
