#include "server/physics/cutting/skin.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

/// The boundary face met on the way round a–b through the tetrahedra, from face k of `tet`: 4·tet + face.
std::uint64_t face_across(const TetComplex& complex, TetId tet, std::size_t k, NodeId a, NodeId b) {
  for (;;) {
    const auto& c = complex.corners(tet);
    std::size_t other = 0;
    while (other == k || c[other] == a || c[other] == b) ++other;
    const TetId next = complex.neighbor(tet, other);
    if (next == TetComplex::none) return 4ull * tet + other;
    for (k = 0; complex.neighbor(next, k) != tet;) ++k;
    tet = next;
  }
}

void add_boundary(const TetComplex& complex, TetId tet, std::vector<std::array<std::uint32_t, 2>>& faces) {
  for (std::uint32_t k = 0; k < 4; ++k)
    if (complex.neighbor(tet, k) == TetComplex::none) faces.push_back({tet, k});
}

/// The tetrahedra at these nodes, each once; ascending.
std::vector<TetId> stars(const TetComplex& complex, std::span<const NodeId> nodes) {
  std::vector<std::uint8_t> seen(complex.node_end(), 0), met(complex.tet_end(), 0);
  std::vector<TetId> out;
  for (const NodeId node : nodes) {
    if (std::exchange(seen[node], std::uint8_t{1}) != 0) continue;
    for (const TetId t : complex.star(node))
      if (std::exchange(met[t], std::uint8_t{1}) == 0) out.push_back(t);
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace

Skin::Skin(const TetComplex& complex) {
  update(complex);
}

Skin::Change Skin::begin(const TetComplex& complex) {
  Change change;
  change.first_vertex = static_cast<std::uint32_t>(vertices_.size());
  slot_of_.resize(16 * complex.tet_end(), none);
  vertex_of_.resize(complex.node_end(), none);
  ++now_;
  return change;
}

void Skin::end(Change& change) const {
  std::sort(change.slots.begin(), change.slots.end());
  for (const std::uint32_t slot : change.slots) change.triangles.push_back(triangles_[slot]);
  change.vertices.assign(vertices_.begin() + change.first_vertex, vertices_.end());
}

Skin::Change Skin::update(const TetComplex& complex) {
  if (complex.is_sheet()) return {};
  Change change = begin(complex);
  std::vector<Face> faces;
  for (TetId t = 0; t < complex.tet_end(); ++t)
    if (complex.has_tet(t)) add_boundary(complex, t, faces);
  find_double_edges(complex, faces);
  for (const auto& [t, k] : faces) put_face(complex, t, k, change);
  for (std::uint32_t slot = 0; slot < triangles_.size(); ++slot) clear_unseen(slot, change);
  end(change);
  return change;
}

Skin::Change Skin::follow(const TetComplex& complex, std::span<const TetId> touched) {
  if (complex.is_sheet()) return {};
  Change change = begin(complex);
  const std::vector<Face> faces = faces_near(complex, touched);
  // How many faces an edge has is told by all that are at its ends.
  std::vector<NodeId> corners;
  for (const auto& [t, k] : faces)
    for (const std::size_t i : TetComplex::face[k]) corners.push_back(complex.corners(t)[i]);
  std::vector<Face> around;
  for (const TetId t : stars(complex, corners)) add_boundary(complex, t, around);
  find_double_edges(complex, around);
  for (const auto& [t, k] : faces) put_face(complex, t, k, change);
  const auto clear_parts = [&](std::size_t key, std::size_t count) {
    for (; count > 0; --count, ++key)
      if (slot_of_[key] != none) clear_unseen(slot_of_[key], change);
  };
  for (const auto& [t, k] : faces) clear_parts(16ull * t + 4 * k, 4);
  for (const TetId t : touched) clear_parts(16ull * t, 16);
  end(change);
  return change;
}

/// Boundary faces that may have become others: of what was touched, and of what has an edge in common with
/// it, since an edge's faces share their middles. Ascending.
std::vector<Skin::Face> Skin::faces_near(const TetComplex& complex, std::span<const TetId> touched) const {
  std::vector<NodeId> corners;
  std::vector<std::uint8_t> is_corner(complex.node_end(), 0);
  for (const TetId t : touched)
    if (complex.has_tet(t))
      for (const NodeId node : complex.corners(t)) {
        corners.push_back(node);
        is_corner[node] = 1;
      }
  std::vector<Face> faces;
  for (const TetId t : stars(complex, corners)) add_boundary(complex, t, faces);
  std::erase_if(faces, [&](const Face& face) {
    int common = 0;
    for (const std::size_t i : TetComplex::face[face[1]]) common += is_corner[complex.corners(face[0])[i]];
    return common < 2;
  });
  return faces;
}

void Skin::clear_unseen(std::uint32_t slot, Change& change) {
  if (seen_[slot] == now_ || triangles_[slot] == Triangle{}) return;
  triangles_[slot] = {};
  change.slots.push_back(slot);
}

// Only between nodes of walls can more than two boundary faces have an edge in common.
void Skin::find_double_edges(const TetComplex& complex, std::span<const Face> faces) {
  std::vector<std::uint8_t> at_wall(complex.node_end(), 0);
  for (const auto& [t, k] : faces)
    if (complex.is_wall(t, k))
      for (const std::size_t i : TetComplex::face[k]) at_wall[complex.corners(t)[i]] = 1;
  // Of the two faces at an edge one runs along it upwards; where two do, it has four.
  std::vector<std::uint64_t> upwards;
  for (const auto& [t, k] : faces)
    for (std::size_t i = 0; i < 3; ++i) {
      const NodeId a = complex.corners(t)[TetComplex::face[k][i]];
      const NodeId b = complex.corners(t)[TetComplex::face[k][(i + 1) % 3]];
      if (a < b && at_wall[a] && at_wall[b]) upwards.push_back(std::uint64_t{a} << 32 | b);
    }
  std::sort(upwards.begin(), upwards.end());
  double_edges_.clear();
  for (std::size_t i = 1; i < upwards.size(); ++i) {
    const Edge edge = {static_cast<NodeId>(upwards[i] >> 32), static_cast<NodeId>(upwards[i])};
    if (upwards[i] == upwards[i - 1] && (double_edges_.empty() || double_edges_.back() != edge))
      double_edges_.push_back(edge);
  }
}

std::uint32_t Skin::corner(NodeId node) {
  std::uint32_t& slot = vertex_of_[node];
  if (slot == none) {
    slot = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back({{node, node}});
  }
  return slot;
}

// A pair of faces is named by the lower of the two.
std::uint32_t Skin::middle(const TetComplex& complex, TetId tet, std::size_t k, const Edge& edge) {
  const std::uint64_t face =
      std::min<std::uint64_t>(4ull * tet + k, face_across(complex, tet, k, edge[0], edge[1]));
  const auto [it, fresh] =
      middle_of_.try_emplace({face, edge[0], edge[1]}, static_cast<std::uint32_t>(vertices_.size()));
  if (fresh) vertices_.push_back({edge});
  return it->second;
}

void Skin::set(std::uint64_t key, const Triangle& triangle, Change& change) {
  std::uint32_t& slot = slot_of_[key];
  if (slot == none) {
    slot = static_cast<std::uint32_t>(triangles_.size());
    triangles_.emplace_back();
    key_.push_back(key);
    seen_.push_back(0);
  }
  seen_[slot] = now_;
  if (triangles_[slot] == triangle) return;
  triangles_[slot] = triangle;
  change.slots.push_back(slot);
}

void Skin::put_face(const TetComplex& complex, TetId tet, std::size_t k, Change& change) {
  std::array<std::uint32_t, 3> c{}, m{};
  std::size_t middles = 0, last = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const NodeId a = complex.corners(tet)[TetComplex::face[k][i]];
    const NodeId b = complex.corners(tet)[TetComplex::face[k][(i + 1) % 3]];
    const Edge edge = {std::min(a, b), std::max(a, b)};
    c[i] = corner(a);
    m[i] = none;
    if (!std::binary_search(double_edges_.begin(), double_edges_.end(), edge)) continue;
    m[i] = middle(complex, tet, k, edge);
    ++middles;
    last = i;
  }
  const bool inner = complex.is_wall(tet, k);
  std::uint64_t key = 16ull * tet + 4 * k;
  const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    set(key++, {{x, y, z}, inner}, change);
  };
  if (middles == 0) return add(c[0], c[1], c[2]);
  if (middles == 3) {
    for (std::size_t i = 0; i < 3; ++i) add(m[(i + 2) % 3], c[i], m[i]);
    return add(m[0], m[1], m[2]);
  }
  // From edge i's middle, whose two neighbours are the next edge's and the one's before: one of these at
  // most.
  const std::size_t i = last, next = (i + 1) % 3, before = (i + 2) % 3;
  if (m[next] != none) {
    add(m[i], c[next], m[next]);
    add(m[i], m[next], c[before]);
  } else {
    add(m[i], c[next], c[before]);
  }
  if (m[before] != none) {
    add(m[i], c[before], m[before]);
    add(m[i], m[before], c[i]);
  } else {
    add(m[i], c[before], c[i]);
  }
}

}  // namespace prosector
