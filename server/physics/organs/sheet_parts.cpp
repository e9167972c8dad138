#include "server/physics/organs/sheet_parts.h"

#include <algorithm>

namespace prosector {
namespace {

/// Whether both triangles of the compiled sheet's cell are there as they were, and hold together.
bool is_whole(const TetComplex& complex, std::size_t cell, const std::array<std::uint32_t, 4>& corners) {
  const auto first = static_cast<TetId>(2 * cell), second = first + 1;
  if (!complex.has_tet(first) || !complex.has_tet(second) || complex.neighbor(first, 1) != second)
    return false;
  const auto a = complex.corners(first), b = complex.corners(second);
  return std::equal(a.begin(), a.end(), std::array{corners[0], corners[1], corners[2]}.begin()) &&
         std::equal(b.begin(), b.end(), std::array{corners[0], corners[2], corners[3]}.begin());
}

class SheetPiece {
 public:
  SheetPiece(const TetComplex& complex, const PieceMesh& piece, const Anatomy& whole, Numbering& numbering)
      : complex_(complex), piece_(piece), whole_(whole), numbering_(numbering) {}

  Anatomy build() {
    numbering_ = {piece_.nodes, {}, {}};
    out_.tets.positions = piece_.mesh.positions;
    out_.thickness = whole_.thickness;
    for (const NodeId node : piece_.nodes)
      out_.node_volume.push_back(complex_.mass(node) / complex_.density());
    add_cells();
    add_vertices();
    add_triangles();
    return std::move(out_);
  }

 private:
  std::uint32_t index(NodeId node) const {
    const auto at = std::lower_bound(piece_.nodes.begin(), piece_.nodes.end(), node);
    return static_cast<std::uint32_t>(at - piece_.nodes.begin());
  }

  void add_cells() {
    const auto compiled = static_cast<TetId>(2 * whole_.quads.size());
    for (const TetId t : piece_.tets) {
      if (t < compiled && is_whole(complex_, t / 2, whole_.quads[t / 2])) {
        const auto& q = whole_.quads[t / 2];
        if (t % 2 == 0) out_.quads.push_back({index(q[0]), index(q[1]), index(q[2]), index(q[3])});
        continue;
      }
      const auto c = complex_.corners(t);
      out_.triangles.push_back({index(c[0]), index(c[1]), index(c[2])});
    }
  }

  /// Of the compiled sheet's n nodes: i above, n + i below; of each other both sides, one after the other.
  void add_vertices() {
    const auto n = static_cast<NodeId>(whole_.tets.positions.size());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;  // number, node
    for (std::uint32_t i = 0; i < piece_.nodes.size(); ++i) {
      const NodeId id = piece_.nodes[i];
      found.emplace_back(id < n ? id : 2 * id, i);
      found.emplace_back(id < n ? n + id : 2 * id + 1, i);
    }
    std::sort(found.begin(), found.end());
    above_.resize(piece_.nodes.size());
    below_.resize(piece_.nodes.size());
    for (const auto& [number, i] : found) {
      const NodeId id = piece_.nodes[i];
      (number == (id < n ? id : 2 * id) ? above_ : below_)[i] =
          static_cast<std::uint32_t>(numbering_.vertices.size());
      numbering_.vertices.push_back(number);
      out_.surface.positions.push_back(complex_.rest(id));
      out_.embedding.rows.push_back({{i, i, i, i}, {1, 0, 0, 0}});
    }
  }

  /// Of a compiled cell as make_sheet() has them: two above, two below; of each other triangle both sides.
  void add_triangles() {
    const auto compiled = static_cast<TetId>(2 * whole_.quads.size());
    struct Found {
      std::uint32_t number;
      TetId tet;
      bool above;
    };
    std::vector<Found> found;
    for (const TetId t : piece_.tets) {
      const std::uint32_t first = t < compiled ? 4 * (t / 2) + t % 2 : 2 * t;
      found.push_back({first, t, true});
      found.push_back({t < compiled ? first + 2 : first + 1, t, false});
    }
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.number < b.number; });
    for (const Found& f : found) {
      const auto c = complex_.corners(f.tet);
      const std::uint32_t i = index(c[0]), j = index(c[1]), k = index(c[2]);
      if (f.above)
        out_.surface.triangles.push_back({above_[i], above_[j], above_[k]});
      else
        out_.surface.triangles.push_back({below_[i], below_[k], below_[j]});
      numbering_.triangles.push_back(f.number);
    }
  }

  const TetComplex& complex_;
  const PieceMesh& piece_;
  const Anatomy& whole_;
  Numbering& numbering_;
  std::vector<std::uint32_t> above_, below_;  // vertices, by node
  Anatomy out_;
};

}  // namespace

Anatomy sheet_piece(const TetComplex& complex, const PieceMesh& piece, const Anatomy& whole,
                    Numbering& numbering) {
  return SheetPiece(complex, piece, whole, numbering).build();
}

Anatomy sheet_remnant(const Anatomy& whole) {
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

}  // namespace prosector
