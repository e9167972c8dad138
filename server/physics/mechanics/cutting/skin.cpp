#include "server/physics/mechanics/cutting/skin.h"

#include <algorithm>
#include <utility>

#include "common/assert.h"

namespace prosector::cutting {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

constexpr double most_shift = 2;  // largest change of a barycentric weight by the outer shape's offset

/// Returns the largest tetrahedron around edge a–b between boundary face k of `tet` and the next boundary
/// face. Of equal volumes, returns the lowest id.
TetId largest_around(const TetComplex& complex, TetId tet, std::size_t k, const std::array<NodeId, 2>& edge) {
  TetId largest = tet;
  for (;;) {
    if (complex.volume(tet) > complex.volume(largest) ||
        (complex.volume(tet) == complex.volume(largest) && tet < largest))
      largest = tet;
    const auto& c = complex.corners(tet);
    std::size_t other = 0;
    while (other == k || c[other] == edge[0] || c[other] == edge[1]) ++other;
    PROSECTOR_ASSERT(other < c.size());
    const TetId next = complex.neighbor(tet, other);
    if (next == TetComplex::none) return largest;
    for (k = 0; complex.neighbor(next, k) != tet;) ++k;
    tet = next;
  }
}

TetId largest_at(const TetComplex& complex, NodeId node) {
  PROSECTOR_ASSERT(!complex.star(node).empty());
  TetId largest = complex.star(node).front();
  for (const TetId tet : complex.star(node))
    if (complex.volume(tet) > complex.volume(largest)) largest = tet;
  return largest;
}

/// Returns the changes of a tetrahedron's barycentric weights for the offset.
std::array<double, 4> shift_of(const TetComplex& complex, TetId tet, const Vec3& offset) {
  const auto c = complex.corners(tet);
  Mat3 edges;
  for (int k = 0; k < 3; ++k)
    edges.col(k) = complex.rest(c[static_cast<std::size_t>(k) + 1]) - complex.rest(c[0]);
  const Vec3 w = edges.inverse() * offset;
  const Eigen::Vector4d all(-w.sum(), w[0], w[1], w[2]);
  const double most = all.cwiseAbs().maxCoeff(), keep = most > most_shift ? most_shift / most : 1;
  return {keep * all[0], keep * all[1], keep * all[2], keep * all[3]};
}

void add_boundary(const TetComplex& complex, TetId tet, std::vector<std::array<std::uint32_t, 2>>& faces) {
  PROSECTOR_ASSERT(complex.has_tet(tet));
  for (std::uint32_t k = 0; k < 4; ++k)
    if (complex.neighbor(tet, k) == TetComplex::none) faces.push_back({tet, k});
}

/// Returns the tetrahedra at these nodes without duplicates, ascending.
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

Skin::Skin(const TetComplex& complex, std::shared_ptr<const OuterShape> shape) : shape_(std::move(shape)) {
  if (shape_ && shape_->is_boundary()) shape_ = nullptr;
  update(complex);
}

Skin::Change Skin::begin(const TetComplex& complex) {
  Change change;
  change.first_vertex = static_cast<std::uint32_t>(vertices_.size());
  slot_of_.resize(16 * complex.tet_end(), none);
  vertex_of_.resize(complex.node_end(), none);
  found_.resize(complex.node_end(), 0);
  newest_.resize(complex.node_end(), none);
  if (shape_) {
    place_.resize(complex.node_end());
    placed_.resize(complex.node_end(), 0);
  }
  ++now_;
  return change;
}

void Skin::end(Change& change) const {
  std::sort(change.slots.begin(), change.slots.end());
  PROSECTOR_ASSERT(is_ascending(change.slots) && key_.size() == triangles_.size() &&
                   seen_.size() == triangles_.size());
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
  // The number of faces at an edge follows from all faces at its ends.
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

/// Returns the boundary faces that may have changed, ascending: faces of touched tetrahedra, and faces that
/// share an edge with them, since the faces of an edge share its midpoint. Faces that share only one node are
/// included if the node lies on the outer shape: its vertex is attached to a tetrahedron.
std::vector<Skin::Face> Skin::faces_near(const TetComplex& complex, std::span<const TetId> touched) {
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
    for (const std::size_t i : TetComplex::face[face[1]]) {
      const NodeId node = complex.corners(face[0])[i];
      if (is_corner[node] == 0) continue;
      if (shape_ && place(complex, node).nodes > 0) return false;
      ++common;
    }
    return common < 2;
  });
  return faces;
}

void Skin::clear_unseen(std::uint32_t slot, Change& change) {
  PROSECTOR_ASSERT(slot < triangles_.size());
  if (seen_[slot] == now_ || triangles_[slot] == Triangle{}) return;
  triangles_[slot] = {};
  change.slots.push_back(slot);
}

// Only edges between nodes of walls can have more than two boundary faces.
void Skin::find_double_edges(const TetComplex& complex, std::span<const Face> faces) {
  std::vector<std::uint8_t> at_wall(complex.node_end(), 0);
  for (const auto& [t, k] : faces)
    if (complex.is_wall(t, k))
      for (const std::size_t i : TetComplex::face[k]) at_wall[complex.corners(t)[i]] = 1;
  // One of the two faces at an edge traverses it from the lower to the higher node; if two faces do, the edge
  // has four faces.
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

/// Returns a node's place on the outer shape, cached by node. Ids are never reused for another node, and a
/// repeated cut places a node between the same nodes.
const OuterShape::Place& Skin::place(const TetComplex& complex, NodeId node) {
  PROSECTOR_ASSERT(shape_ != nullptr && node < placed_.size());
  if (std::exchange(placed_[node], std::uint8_t{1}) != 0) return place_[node];
  const TetComplex::Origin& from = complex.tables().origin[node];
  PROSECTOR_ASSERT(from.a == node || (from.a < node && from.b < node));
  if (from.a == node)
    place_[node] = shape_->place(node);
  else if (from.a == from.b)
    place_[node] = place(complex, from.a);
  else
    place_[node] = shape_->between(place(complex, from.a), place(complex, from.b), from.t);
  return place_[node];
}

/// Returns the offset of a node or of an edge's midpoint, m.
Vec3 Skin::offset(const TetComplex& complex, const Edge& edge) {
  if (!shape_) return Vec3::Zero();
  const OuterShape::Place &a = place(complex, edge[0]), &b = place(complex, edge[1]);
  if (edge[0] == edge[1]) return shape_->offset(a);
  const OuterShape::Place half = shape_->between(a, b, 0.5);
  if (half.nodes == 0) return (shape_->offset(a) + shape_->offset(b)) / 2;  // an edge inside the body
  return shape_->offset(half);
}

bool Skin::has_middle(const TetComplex& complex, const Edge& edge) {
  if (shape_ && shape_->has_middle(place(complex, edge[0]), place(complex, edge[1]))) return true;
  return std::binary_search(double_edges_.begin(), double_edges_.end(), edge);
}

std::uint32_t Skin::corner(const TetComplex& complex, NodeId node) {
  if (std::exchange(found_[node], now_) == now_) return vertex_of_[node];
  const bool is_off = shape_ && !shape_->offset(place(complex, node)).isZero(0);
  return vertex_of_[node] =
             vertex(complex, {node, node}, is_off ? largest_at(complex, node) : TetComplex::none);
}

/// Returns the vertex of an edge's midpoint. Each pair of faces at an edge has its own vertex.
std::uint32_t Skin::middle(const TetComplex& complex, TetId tet, std::size_t k, const Edge& edge) {
  return vertex(complex, edge, largest_around(complex, tet, k, edge));
}

std::uint32_t Skin::vertex(const TetComplex& complex, const Edge& edge, TetId carrier) {
  PROSECTOR_ASSERT(edge[0] <= edge[1] && edge[1] < complex.node_end());
  Name name{edge, {none, none, none, none}};
  if (carrier != TetComplex::none) std::ranges::copy(complex.corners(carrier), name.carrier.begin());
  for (std::uint32_t slot = newest_[edge[0]]; slot != none; slot = next_[slot])
    if (name_[slot] == name) return slot;
  Vertex made{{edge[0]}, {1}};
  if (carrier != TetComplex::none) {
    PROSECTOR_ASSERT(has_corner(complex, carrier, edge[0]) && has_corner(complex, carrier, edge[1]));
    const Vec3 off = offset(complex, edge);
    made.node = name.carrier;
    made.weight = off.isZero(0) ? std::array<double, 4>{} : shift_of(complex, carrier, off);
    for (const NodeId end : edge) made.weight[complex.corner_index(carrier, end)] += 0.5;
  }
  const auto slot = static_cast<std::uint32_t>(vertices_.size());
  vertices_.push_back(made);
  name_.push_back(name);
  next_.push_back(std::exchange(newest_[edge[0]], slot));
  return slot;
}

void Skin::set(std::uint64_t key, const Triangle& triangle, Change& change) {
  PROSECTOR_ASSERT(key < slot_of_.size());
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
  PROSECTOR_ASSERT(complex.has_tet(tet) && k < 4 && complex.neighbor(tet, k) == TetComplex::none);
  std::array<std::uint32_t, 3> c{}, m{};
  std::size_t middles = 0, last = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const NodeId a = complex.corners(tet)[TetComplex::face[k][i]];
    const NodeId b = complex.corners(tet)[TetComplex::face[k][(i + 1) % 3]];
    const Edge edge = {std::min(a, b), std::max(a, b)};
    c[i] = corner(complex, a);
    m[i] = none;
    if (!has_middle(complex, edge)) continue;
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
  // Triangles around the midpoint of edge i. At most one of the next and the previous edge has a midpoint
  // too.
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

}  // namespace prosector::cutting
