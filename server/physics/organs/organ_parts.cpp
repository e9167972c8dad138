#include "server/physics/organs/organ_parts.h"

#include <algorithm>

namespace prosector {
namespace {

constexpr std::uint32_t unused = ~0U;

/// Appends what `op` touched.
struct Touched {
  const TetComplex& complex;
  std::vector<TetId>& out;

  void operator()(const SplitEdge& op) const {
    for (std::uint32_t i = 0; i < op.count; ++i) {
      const TetId child = op.first + 2 * i;
      out.insert(out.end(), {complex.parent(child), child, child + 1});
    }
  }
  void operator()(const SlitFaces& op) const {
    for (const auto& pair : op.faces) out.insert(out.end(), pair.begin(), pair.end());
  }
  void operator()(const PartNode& op) const {
    const auto stayed = complex.star(op.node);
    out.insert(out.end(), stayed.begin(), stayed.end());
    for (const PartNode::Copy& copy : op.copies) out.insert(out.end(), copy.tets.begin(), copy.tets.end());
  }
};

}  // namespace

Anatomy without_edge_nodes(const Anatomy& anatomy) {
  std::uint32_t vertices = 0;
  for (const auto& tet : anatomy.tets.tets)
    for (const std::uint32_t corner : tet) vertices = std::max(vertices, corner + 1);
  Anatomy out = anatomy;
  if (out.tets.positions.size() == vertices) return out;
  std::vector<std::array<std::uint32_t, 2>> ends(anatomy.tets.positions.size() - vertices);
  for (const auto& [key, node] : edge_nodes_of(anatomy.tets.tets, vertices))
    ends[node - vertices] = {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
  out.tets.positions.resize(vertices);
  for (SparseMap::Row& row : out.embedding.rows) {
    SparseMap::Row on_vertices;
    std::size_t used = 0;
    const auto add = [&](std::uint32_t node, double weight) {
      std::size_t at = 0;
      while (at < used && on_vertices.node[at] != node) ++at;
      if (at == used) on_vertices.node[used++] = node;
      on_vertices.weight[at] += weight;
    };
    for (std::size_t k = 0; k < 4; ++k) {
      if (row.weight[k] == 0) continue;
      if (row.node[k] < vertices) {
        add(row.node[k], row.weight[k]);
        continue;
      }
      for (const std::uint32_t end : ends[row.node[k] - vertices]) add(end, row.weight[k] / 2);
    }
    row = on_vertices;
  }
  return out;
}

PieceMesh piece_mesh(const TetComplex& complex, std::vector<TetId> tets) {
  PieceMesh out;
  out.tets = std::move(tets);
  std::vector<std::uint32_t> index(complex.node_end(), unused);
  for (const TetId tet : out.tets)
    for (const NodeId node : complex.corners(tet)) index[node] = 0;
  for (NodeId node = 0; node < index.size(); ++node) {
    if (index[node] == unused) continue;
    index[node] = static_cast<std::uint32_t>(out.nodes.size());
    out.nodes.push_back(node);
    out.mesh.positions.push_back(complex.rest(node));
  }
  for (const TetId tet : out.tets) {
    const TetComplex::Corners& c = complex.corners(tet);
    out.mesh.tets.push_back({index[c[0]], index[c[1]], index[c[2]], index[c[3]]});
  }
  return out;
}

std::vector<TetId> touched_by(const TetComplex& complex, const std::vector<TopologyOp>& ops) {
  std::vector<TetId> out;
  for (const TopologyOp& op : ops) std::visit(Touched{complex, out}, op);
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

Anatomy skinned(const TetComplex& complex, const Skin& skin, const PieceMesh& piece,
                std::uint32_t first_vertex, std::uint32_t first_triangle, Numbering& numbering) {
  numbering = {piece.nodes, {}, {}};
  Anatomy out;
  out.tets = piece.mesh;
  std::vector<char> in_piece(complex.tet_end(), 0);
  for (const TetId tet : piece.tets) in_piece[tet] = 1;
  std::vector<std::uint32_t> index(complex.node_end(), unused);  // by node
  for (std::uint32_t n = 0; n < piece.nodes.size(); ++n) index[piece.nodes[n]] = n;
  std::vector<std::uint32_t> vertex(skin.vertices().size(), unused);  // by slot
  for (std::uint32_t slot = 0; slot < skin.triangles().size(); ++slot) {
    const Skin::Triangle& triangle = skin.triangles()[slot];
    if (triangle.corners[0] == triangle.corners[1] || !in_piece[skin.tet(slot)]) continue;
    out.surface.triangles.push_back(triangle.corners);
    out.surface.inner.push_back(triangle.inner ? 1 : 0);
    numbering.triangles.push_back(first_triangle + slot);
    for (const std::uint32_t corner : triangle.corners) vertex[corner] = 0;
  }
  for (std::uint32_t slot = 0; slot < vertex.size(); ++slot) {
    if (vertex[slot] == unused) continue;
    vertex[slot] = static_cast<std::uint32_t>(out.embedding.rows.size());
    const auto [a, b] = skin.vertices()[slot].node;
    SparseMap::Row& row = out.embedding.rows.emplace_back();
    row.node = {index[a], a == b ? 0 : index[b], 0, 0};
    row.weight = {a == b ? 1 : 0.5, a == b ? 0 : 0.5, 0, 0};
    out.surface.positions.push_back(a == b ? complex.rest(a) : Vec3((complex.rest(a) + complex.rest(b)) / 2));
    numbering.vertices.push_back(first_vertex + slot);
  }
  for (auto& corners : out.surface.triangles)
    for (std::uint32_t& corner : corners) corner = vertex[corner];
  return out;
}

Anatomy remnant(const Anatomy& whole) {
  Anatomy out;
  for (const std::uint32_t corner : whole.tets.tets.front())
    out.tets.positions.push_back(whole.tets.positions[corner]);
  out.tets.tets = {{0, 1, 2, 3}};
  return out;
}

}  // namespace prosector
