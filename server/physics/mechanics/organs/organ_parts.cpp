#include "server/physics/mechanics/organs/organ_parts.h"

#include <algorithm>

#include "common/assert.h"
#include "server/physics/mechanics/organs/sheet_parts.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector::organs {
namespace {

constexpr std::uint32_t no_index = ~0U;
// Share of changed tetrahedra up to which an incremental update costs less.
constexpr double most_others = 0.25;

}  // namespace

Anatomy without_edge_nodes(const Anatomy& anatomy) {
  std::uint32_t vertices = 0;
  for (const auto& tet : anatomy.tets.tets)
    for (const std::uint32_t corner : tet) vertices = std::max(vertices, corner + 1);
  Anatomy out = anatomy;
  if (anatomy.tets.tets.empty() || out.tets.positions.size() == vertices) return out;
  const soft::EdgeNodes edges(anatomy.tets.tets, vertices);
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
      for (const std::uint32_t end : edges.ends(row.node[k])) add(end, row.weight[k] / 2);
    }
    row = on_vertices;
  }
  return out;
}

PieceMesh piece_mesh(const cutting::TetComplex& complex, std::span<const cutting::TetId> tets) {
  PieceMesh out;
  std::vector<cutting::TetId> at_place(complex.tet_end(), cutting::TetComplex::none);
  for (const cutting::TetId tet : tets) at_place[complex.lineage(tet).place] = tet;
  for (cutting::TetId place = 0; place < at_place.size(); ++place)
    if (at_place[place] != cutting::TetComplex::none) {
      out.tets.push_back(at_place[place]);
      out.places.push_back(place);
    }
  PROSECTOR_ASSERT(out.tets.size() == tets.size());
  std::vector<std::uint32_t> index(complex.node_end(), no_index);
  for (const cutting::TetId tet : out.tets)
    for (const cutting::NodeId node : complex.corners(tet)) index[node] = 0;
  for (cutting::NodeId node = 0; node < index.size(); ++node) {
    if (index[node] == no_index) continue;
    index[node] = static_cast<std::uint32_t>(out.nodes.size());
    out.nodes.push_back(node);
    out.mesh.positions.push_back(complex.rest(node));
  }
  for (const cutting::TetId tet : out.tets) {
    const auto c = complex.corners(tet);
    out.mesh.tets.push_back({index[c[0]], index[c[1]], index[c[2]], index[c.back()]});
  }
  return out;
}

PieceEdit edit_of(const cutting::TetComplex& complex, const PieceMesh& piece,
                  std::vector<cutting::TetId> touched) {
  PROSECTOR_ASSERT(!piece.nodes.empty() && piece.places.size() == piece.tets.size() &&
                   piece.mesh.tets.size() == piece.tets.size());
  PieceEdit out;
  std::erase_if(touched, [&](cutting::TetId tet) { return !complex.has_tet(tet); });
  std::sort(touched.begin(), touched.end(), [&](cutting::TetId a, cutting::TetId b) {
    return complex.lineage(a).place < complex.lineage(b).place;
  });
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const cutting::TetId tet : touched)
    for (const cutting::NodeId node : complex.corners(tet))
      if (node > piece.nodes.back()) out.nodes.push_back(node);
  std::sort(out.nodes.begin(), out.nodes.end());
  out.nodes.erase(std::unique(out.nodes.begin(), out.nodes.end()), out.nodes.end());
  const std::size_t known = piece.nodes.size();
  out.mesh.kept_nodes = soft::Kept::all(known, known + out.nodes.size());
  for (std::size_t i = 0; i < out.nodes.size(); ++i) {
    out.mesh.made_nodes.push_back(static_cast<std::uint32_t>(known + i));
    out.mesh.positions.push_back(complex.rest(out.nodes[i]));
  }
  const auto index = [&](cutting::NodeId node) {
    const bool is_new = node > piece.nodes.back();
    const std::vector<cutting::NodeId>& among = is_new ? out.nodes : piece.nodes;
    const auto at = std::lower_bound(among.begin(), among.end(), node) - among.begin();
    return static_cast<std::uint32_t>(at) + static_cast<std::uint32_t>(is_new ? piece.nodes.size() : 0);
  };
  auto end = static_cast<std::uint32_t>(piece.tets.size());
  for (const cutting::TetId tet : touched) {
    const auto c = complex.corners(tet);
    const soft::MeshEdit::Corners corners = {index(c[0]), index(c[1]), index(c[2]), index(c.back())};
    const auto at = std::lower_bound(piece.places.begin(), piece.places.end(), complex.lineage(tet).place);
    if (at != piece.places.end()) {
      const auto i = static_cast<std::uint32_t>(at - piece.places.begin());
      const soft::MeshEdit::Corners& before = piece.mesh.tets[i];
      if (piece.tets[i] == tet && corners == before) continue;
      out.mesh.tets.push_back(i);
      out.mesh.nodes.insert(out.mesh.nodes.end(), before.begin(), before.end());
    } else {
      out.mesh.tets.push_back(end++);
    }
    out.mesh.corners.push_back(corners);
    out.mesh.nodes.insert(out.mesh.nodes.end(), corners.begin(), corners.end());
    out.tets.push_back(tet);
  }
  out.mesh.kept_tets = soft::Kept::all(piece.tets.size(), end);
  std::sort(out.mesh.nodes.begin(), out.mesh.nodes.end());
  out.mesh.nodes.erase(std::unique(out.mesh.nodes.begin(), out.mesh.nodes.end()), out.mesh.nodes.end());
  return out;
}

PieceEdit edit_between(const PieceMesh& before, const PieceMesh& now) {
  PROSECTOR_ASSERT(is_ascending(before.nodes) && is_ascending(before.places) &&
                   before.places.size() == before.tets.size());
  PROSECTOR_ASSERT(is_ascending(now.nodes) && is_ascending(now.places) &&
                   now.places.size() == now.tets.size());
  PieceEdit piece;
  soft::MeshEdit& out = piece.mesh;
  out.kept_nodes.before = before.nodes.size();
  out.kept_nodes.now = now.nodes.size();
  for (std::uint32_t i = 0, j = 0; j < now.nodes.size(); ++j) {
    while (i < before.nodes.size() && before.nodes[i] < now.nodes[j]) ++i;
    if (i < before.nodes.size() && before.nodes[i] == now.nodes[j]) {
      out.kept_nodes.add(i, j);
    } else {
      out.made_nodes.push_back(j);
      out.positions.push_back(now.mesh.positions[j]);
      piece.nodes.push_back(now.nodes[j]);
    }
  }
  const std::vector<std::uint32_t> destination = out.kept_nodes.destinations();
  std::vector<char> met(now.nodes.size(), 0);
  std::uint32_t i = 0;
  const auto gone = [&] {
    for (const std::uint32_t corner : before.mesh.tets[i])
      if (destination[corner] != soft::Kept::none) met[destination[corner]] = 1;
    ++i;
  };
  out.kept_tets.before = before.tets.size();
  out.kept_tets.now = now.tets.size();
  for (std::uint32_t j = 0; j < now.tets.size(); ++j) {
    while (i < before.tets.size() && before.places[i] < now.places[j]) gone();
    const soft::MeshEdit::Corners& corners = now.mesh.tets[j];
    if (i < before.tets.size() && before.places[i] == now.places[j]) {
      out.kept_tets.add(i, j);
      const soft::MeshEdit::Corners& were = before.mesh.tets[i];
      if (std::equal(were.begin(), were.end(), corners.begin(),
                     [&](std::uint32_t a, std::uint32_t b) { return destination[a] == b; })) {
        ++i;
        continue;
      }
      gone();
    }
    out.tets.push_back(j);
    out.corners.push_back(corners);
    piece.tets.push_back(now.tets[j]);
    for (const std::uint32_t corner : corners) met[corner] = 1;
  }
  while (i < before.tets.size()) gone();
  for (std::uint32_t node = 0; node < met.size(); ++node)
    if (met[node]) out.nodes.push_back(node);
  return piece;
}

bool is_worth_following(const PieceEdit& edit) {
  return static_cast<double>(edit.mesh.tets.size()) <=
         most_others * static_cast<double>(edit.mesh.kept_tets.now);
}

void apply(const cutting::TetComplex& complex, const PieceEdit& edit, PieceMesh& piece) {
  PROSECTOR_ASSERT(edit.tets.size() == edit.mesh.tets.size());
  PROSECTOR_ASSERT(edit.nodes.empty() || piece.nodes.empty() || piece.nodes.back() < edit.nodes.front());
  piece.nodes.insert(piece.nodes.end(), edit.nodes.begin(), edit.nodes.end());
  soft::apply(edit.mesh, piece.mesh);
  piece.tets.resize(piece.mesh.tets.size());
  piece.places.resize(piece.mesh.tets.size());
  for (std::size_t i = 0; i < edit.tets.size(); ++i) {
    piece.tets[edit.mesh.tets[i]] = edit.tets[i];
    piece.places[edit.mesh.tets[i]] = complex.lineage(edit.tets[i]).place;
  }
}

PieceSurface skinned(const cutting::TetComplex& complex, const cutting::Skin& skin, const PieceMesh& piece,
                     std::uint32_t first_vertex, std::uint32_t first_triangle) {
  PROSECTOR_ASSERT(is_ascending(piece.nodes));
  PieceSurface out;
  out.numbering.nodes = piece.nodes;
  std::vector<char> in_piece(complex.tet_end(), 0);
  for (const cutting::TetId tet : piece.tets) in_piece[tet] = 1;
  std::vector<std::uint32_t> index(complex.node_end(), no_index);  // by node
  for (std::uint32_t n = 0; n < piece.nodes.size(); ++n) index[piece.nodes[n]] = n;
  std::vector<std::uint32_t> vertex(skin.vertices().size(), no_index);  // by slot
  for (std::uint32_t slot = 0; slot < skin.triangles().size(); ++slot) {
    const cutting::Skin::Triangle& triangle = skin.triangles()[slot];
    if (triangle.gone() || !in_piece[skin.tet(slot)]) continue;
    out.surface.triangles.push_back(triangle.corners);
    out.surface.inner.push_back(triangle.inner ? 1 : 0);
    out.numbering.triangles.push_back(first_triangle + slot);
    for (const std::uint32_t corner : triangle.corners) vertex[corner] = 0;
  }
  for (std::uint32_t slot = 0; slot < vertex.size(); ++slot) {
    if (vertex[slot] == no_index) continue;
    vertex[slot] = static_cast<std::uint32_t>(out.embedding.rows.size());
    const auto hung = hang(complex, skin.vertices()[slot], [&](cutting::NodeId node) { return index[node]; });
    out.embedding.rows.push_back(hung.row);
    out.surface.positions.push_back(hung.rest);
    out.numbering.vertices.push_back(first_vertex + slot);
  }
  for (auto& corners : out.surface.triangles)
    for (std::uint32_t& corner : corners) corner = vertex[corner];
  return out;
}

Anatomy remnant(const Anatomy& whole) {
  if (whole.tets.tets.empty()) return sheet_remnant(whole);
  Anatomy out;
  for (const std::uint32_t corner : whole.tets.tets.front())
    out.tets.positions.push_back(whole.tets.positions[corner]);
  out.tets.tets = {{0, 1, 2, 3}};
  out.tets.stretch = whole.tets.stretch;
  return out;
}

}  // namespace prosector::organs
