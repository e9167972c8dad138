#include "server/physics/mechanics/organs/sheet_parts.h"

#include <algorithm>

#include "common/assert.h"

namespace prosector::organs {
namespace {

/// Returns whether both triangles of the compiled sheet's cell are unchanged and connected.
bool is_whole(const cutting::TetComplex& complex, std::size_t cell,
              const std::array<std::uint32_t, 4>& corners) {
  const auto first = static_cast<cutting::TetId>(2 * cell), second = first + 1;
  if (!complex.has_tet(first) || !complex.has_tet(second) || complex.neighbor(first, 1) != second)
    return false;
  const auto a = complex.corners(first), b = complex.corners(second);
  return std::equal(a.begin(), a.end(), std::array{corners[0], corners[1], corners[2]}.begin()) &&
         std::equal(b.begin(), b.end(), std::array{corners[0], corners[2], corners[3]}.begin());
}

class SheetPiece {
 public:
  SheetPiece(const cutting::TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
             Numbering& numbering)
      : complex_(complex), piece_(piece), whole_(whole), numbering_(numbering) {}

  Anatomy build() {
    PROSECTOR_ASSERT(is_ascending(piece_.nodes) && piece_.mesh.positions.size() == piece_.nodes.size());
    numbering_ = {piece_.nodes, {}, {}};
    index_.resize(complex_.node_end());
    for (std::uint32_t i = 0; i < piece_.nodes.size(); ++i) index_[piece_.nodes[i]] = i;
    out_.tets.positions = piece_.mesh.positions;
    out_.thickness = whole_.thickness;
    for (const cutting::NodeId node : piece_.nodes)
      out_.node_volume.push_back(complex_.mass(node) / complex_.density());
    add_cells();
    add_vertices();
    add_triangles();
    return std::move(out_);
  }

 private:
  void add_cells() {
    const auto compiled = static_cast<cutting::TetId>(2 * whole_.quads.size());
    for (const cutting::TetId t : piece_.tets) {
      if (t < compiled && is_whole(complex_, t / 2, whole_.quads[t / 2])) {
        const auto& q = whole_.quads[t / 2];
        if (t % 2 == 0) out_.quads.push_back({index_[q[0]], index_[q[1]], index_[q[2]], index_[q[3]]});
        continue;
      }
      const auto c = complex_.corners(t);
      out_.triangles.push_back({index_[c[0]], index_[c[1]], index_[c[2]]});
    }
  }

  /// Adds the vertices. Of the compiled sheet's n nodes, node i has vertex i above and n + i below. Every
  /// other node has both vertices, one after the other.
  void add_vertices() {
    const auto n = static_cast<cutting::NodeId>(whole_.tets.positions.size());
    const auto nodes = static_cast<std::uint32_t>(piece_.nodes.size());
    const auto compiled = static_cast<std::uint32_t>(
        std::lower_bound(piece_.nodes.begin(), piece_.nodes.end(), n) - piece_.nodes.begin());
    above_.resize(nodes);
    below_.resize(nodes);
    out_.surface.positions.reserve(2 * nodes);
    out_.embedding.rows.reserve(2 * nodes);
    numbering_.vertices.reserve(2 * nodes);
    const auto add = [&](std::vector<std::uint32_t>& side, std::uint32_t i, std::uint32_t number) {
      side[i] = static_cast<std::uint32_t>(numbering_.vertices.size());
      numbering_.vertices.push_back(number);
      out_.surface.positions.push_back(piece_.mesh.positions[i]);
      out_.embedding.rows.push_back({{i, i, i, i}, {1, 0, 0, 0}});
    };
    for (std::uint32_t i = 0; i < compiled; ++i) add(above_, i, piece_.nodes[i]);
    for (std::uint32_t i = 0; i < compiled; ++i) add(below_, i, n + piece_.nodes[i]);
    for (std::uint32_t i = compiled; i < nodes; ++i) {
      add(above_, i, 2 * piece_.nodes[i]);
      add(below_, i, 2 * piece_.nodes[i] + 1);
    }
  }

  /// Adds the triangles. A compiled cell has them in the order of make_sheet(): two above, two below. Every
  /// other triangle has both sides, one after the other.
  void add_triangles() {
    std::vector<char> in_piece(complex_.tet_end(), 0);
    for (const cutting::TetId t : piece_.tets) in_piece[t] = 1;
    const auto compiled = static_cast<cutting::TetId>(2 * whole_.quads.size());
    out_.surface.triangles.reserve(2 * piece_.tets.size());
    numbering_.triangles.reserve(2 * piece_.tets.size());
    const auto add = [&](cutting::TetId t, bool above, std::uint32_t number) {
      if (!in_piece[t]) return;
      const auto c = complex_.corners(t);
      const std::uint32_t i = index_[c[0]], j = index_[c[1]], k = index_[c[2]];
      if (above)
        out_.surface.triangles.push_back({above_[i], above_[j], above_[k]});
      else
        out_.surface.triangles.push_back({below_[i], below_[k], below_[j]});
      numbering_.triangles.push_back(number);
    };
    for (cutting::TetId t = 0; t < compiled; t += 2)
      for (const std::uint32_t side : {0U, 2U})
        for (const std::uint32_t k : {0U, 1U}) add(t + k, side == 0, 2 * t + side + k);
    for (cutting::TetId t = compiled; t < in_piece.size(); ++t) {
      add(t, true, 2 * t);
      add(t, false, 2 * t + 1);
    }
  }

  const cutting::TetComplex& complex_;
  const PieceMesh& piece_;
  const Anatomy& whole_;
  Numbering& numbering_;
  std::vector<std::uint32_t> index_;          // by node id
  std::vector<std::uint32_t> above_, below_;  // vertices, by node
  Anatomy out_;
};

}  // namespace

Anatomy sheet_piece(const cutting::TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
                    Numbering& numbering) {
  return SheetPiece(complex, piece, whole, numbering).build();
}

// A cell is edited as a whole, even if one of its triangles keeps its corners.
std::vector<std::uint32_t> touched_corners(const cutting::TetComplex& complex,
                                           std::span<const cutting::NodeId> nodes,
                                           std::vector<std::uint32_t> edited, const Anatomy& whole,
                                           std::span<const cutting::TetId> touched) {
  for (cutting::TetId t : touched) {
    while (complex.lineage(t).parent != cutting::TetComplex::none) t = complex.lineage(t).parent;
    PROSECTOR_ASSERT(t / 2 < whole.quads.size());
    for (const cutting::NodeId corner : whole.quads[t / 2]) {
      const auto at = std::lower_bound(nodes.begin(), nodes.end(), corner);
      if (at != nodes.end() && *at == corner)
        edited.push_back(static_cast<std::uint32_t>(at - nodes.begin()));
    }
  }
  std::sort(edited.begin(), edited.end());
  edited.erase(std::unique(edited.begin(), edited.end()), edited.end());
  return edited;
}

Anatomy sheet_remnant(const Anatomy& whole) {
  PROSECTOR_ASSERT(!whole.quads.empty());
  Anatomy out;
  for (const std::uint32_t corner : whole.quads.front())
    out.tets.positions.push_back(whole.tets.positions[corner]);
  out.quads = {{0, 1, 2, 3}};
  out.thickness = whole.thickness;
  return out;
}

std::vector<std::uint8_t> held_nodes(const std::vector<AttachDesc>& attach, const Anatomy& sheet) {
  std::vector<std::uint8_t> out;
  for (const Vec3& x : sheet.tets.positions)
    out.push_back(std::any_of(attach.begin(), attach.end(), [&](const AttachDesc& a) {
      return a.stiffness > 0 && (x - a.center).norm() <= a.radius;
    }));
  return out;
}

}  // namespace prosector::organs
