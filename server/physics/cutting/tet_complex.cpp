#include "server/physics/cutting/tet_complex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/fabric.h"
#include "common/anatomy/mesh_quality.h"
#include "common/error.h"
#include "common/hash.h"

namespace prosector {

TetComplex::TetComplex(double density) : density_(density) {
  if (!(density > 0) || !std::isfinite(density))
    throw InputError(fmt::format("cutting: density is {}; allowed: positive, in kg/m³", density));
}

TetComplex::TetComplex(const TetMesh& rest, double density) : TetComplex(density) {
  grow_nodes(rest.positions.size());
  grow_tets(rest.tets.size());
  rest_ = rest.positions;
  tet_ = rest.tets;
  finish();
  for (NodeId i = 0; i < rest_.size(); ++i) update_mass(i);
}

TetComplex TetComplex::of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held) {
  TetComplex out(density);
  out.sides_ = 3;
  out.thickness_ = sheet.thickness;
  out.grow_nodes(sheet.tets.positions.size());
  out.grow_tets(2 * sheet.quads.size());
  out.rest_ = sheet.tets.positions;
  for (std::size_t i = 0; i < sheet.quads.size(); ++i) {
    const auto& [a, b, c, d] = sheet.quads[i];
    out.tet_[2 * i] = {a, b, c, none};
    out.tet_[2 * i + 1] = {a, c, d, none};
  }
  if (!held.empty()) out.held_ = std::move(held);
  out.finish();
  const std::vector<double> volume = sheet_node_volumes(sheet);
  for (NodeId i = 0; i < out.rest_.size(); ++i) out.mass_[i] = density * volume[i];
  return out;
}

void TetComplex::finish() {
  std::fill(node_live_.begin(), node_live_.end(), std::uint8_t{1});
  std::fill(tet_live_.begin(), tet_live_.end(), std::uint8_t{1});
  live_nodes_ = rest_.size();
  live_tets_ = tet_.size();
  for (TetId t = 0; t < tet_.size(); ++t) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < sides_; ++k) {
      const NodeId node = tet_[t][k];
      if (node >= rest_.size())
        throw InputError(
            fmt::format("cutting: tetrahedron {} names node {}; there are {}", t, node, rest_.size()));
      star_[node].push_back(t);
      x[k] = rest_[node];
    }
    place_[t] = t;
    volume_[t] = size(std::span(x).first(sides_));
    if (!(volume_[t] > 0))
      throw InputError(fmt::format("cutting: tetrahedron {} has a rest volume of {} m³; allowed: positive", t,
                                   volume_[t]));
  }
  double volume = 0;
  for (const double v : volume_) volume += v;
  if (live_tets_ > 0) mean_volume_ = volume / static_cast<double>(live_tets_);
  cell_ = is_sheet() ? std::sqrt(4 / std::sqrt(3.0) * mean_volume_ / thickness_)
                     : std::cbrt(6 * std::sqrt(2.0) * mean_volume_);
  join_by_faces();
}

double TetComplex::size(std::span<const Vec3> x) const {
  if (is_sheet()) return thickness_ * (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  return tet_volume(x[0], x[1], x[2], x[3]);
}

void TetComplex::join_by_faces() {
  struct Side {
    std::array<NodeId, 3> key;
    TetId tet;
    std::uint32_t k;
  };
  std::vector<Side> sides;
  sides.reserve(sides_ * tet_.size());
  for (TetId t = 0; t < tet_.size(); ++t)
    for (std::uint32_t k = 0; k < sides_; ++k) {
      std::array<NodeId, 3> key = {tet_[t][face[k][0]], tet_[t][face[k][1]], tet_[t][face[k][2]]};
      std::sort(key.begin(), key.end());
      sides.push_back({key, t, k});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    for (std::size_t i = 0; i < 3; ++i)
      if (a.key[i] != b.key[i]) return a.key[i] < b.key[i];
    return a.tet < b.tet;
  });
  for (std::size_t i = 1; i < sides.size(); ++i) {
    if (sides[i].key != sides[i - 1].key) continue;
    if (i > 1 && sides[i - 2].key == sides[i].key)
      throw InputError(fmt::format("cutting: tetrahedra {}, {} and {} have one face in common; allowed: two",
                                   sides[i - 2].tet, sides[i - 1].tet, sides[i].tet));
    neighbor_[sides[i].tet][sides[i].k] = sides[i - 1].tet;
    neighbor_[sides[i - 1].tet][sides[i - 1].k] = sides[i].tet;
  }
}

void TetComplex::grow_nodes(std::size_t end) {
  if (end <= rest_.size()) return;
  rest_.resize(end, Vec3::Zero());
  mass_.resize(end, 0.0);
  held_.resize(end, 0);
  node_live_.resize(end, 0);
  star_.resize(end);
}

void TetComplex::grow_tets(std::size_t end) {
  if (end <= tet_.size()) return;
  tet_.resize(end, Corners{});
  neighbor_.resize(end, {none, none, none, none});
  wall_.resize(end, 0);
  volume_.resize(end, 0.0);
  parent_.resize(end, none);
  child_.resize(end, none);
  place_.resize(end, none);
  tet_live_.resize(end, 0);
}

bool TetComplex::has_corner(TetId tet, NodeId node) const {
  return corner_index(tet, node) < 4;
}

std::size_t TetComplex::corner_index(TetId tet, NodeId node) const {
  const Corners& c = tet_[tet];
  for (std::size_t k = 0; k < sides_; ++k)
    if (c[k] == node) return k;
  return 4;
}

void TetComplex::around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const {
  tets.clear();
  const NodeId fewer = star_[a].size() <= star_[b].size() ? a : b;
  const NodeId other = fewer == a ? b : a;
  for (const TetId t : star_[fewer])
    if (has_corner(t, other)) tets.push_back(t);
}

std::size_t TetComplex::slot_towards(TetId tet, TetId other) const {
  for (std::size_t k = 0; k < 4; ++k)
    if (neighbor_[tet][k] == other) return k;
  return 4;
}

std::size_t TetComplex::slot_of_face(TetId tet, TetId other) const {
  std::size_t slot = 4, apart = 0;
  for (std::size_t k = 0; k < sides_; ++k)
    if (!has_corner(other, tet_[tet][k])) {
      slot = k;
      ++apart;
    }
  return apart == 1 ? slot : 4;
}

void TetComplex::leave(NodeId node, TetId tet) {
  auto& star = star_[node];
  star.erase(std::lower_bound(star.begin(), star.end(), tet));
}

void TetComplex::enter(NodeId node, TetId tet) {
  auto& star = star_[node];
  star.insert(std::lower_bound(star.begin(), star.end(), tet), tet);
}

// Summed in the order of ids, so that it is the same however the star came about.
void TetComplex::update_mass(NodeId node) {
  double volume = 0;
  for (const TetId t : star_[node]) volume += volume_[t];
  mass_[node] = density_ * volume / 4;
}

void TetComplex::apply(const TopologyOp& op) {
  std::visit([this](const auto& o) { change(o); }, op);
}

void TetComplex::take_back(const TopologyOp& op) {
  std::visit([this](const auto& o) { change_back(o); }, op);
  ++undone_;
}

void TetComplex::continue_from(const TetComplex& later) {
  grow_nodes(later.node_end());
  grow_tets(later.tet_end());
  undone_ = later.undone_ + 1;
}

std::uint64_t TetComplex::content_hash() const {
  StateHasher hash;
  hash.add(density_);
  for (NodeId i = 0; i < rest_.size(); ++i) {
    if (!node_live_[i]) continue;
    hash.add(i);
    hash.add(rest_[i].data(), 3);
    hash.add(mass_[i]);
  }
  for (TetId t = 0; t < tet_.size(); ++t) {
    if (!tet_live_[t]) continue;
    hash.add(t);
    hash.add(std::as_bytes(std::span(tet_[t])));
    hash.add(std::as_bytes(std::span(neighbor_[t])));
    hash.add(wall_[t]);
  }
  return hash.digest();
}

std::vector<NodeId> TetComplex::node_ids() const {
  std::vector<NodeId> ids;
  ids.reserve(live_nodes_);
  for (NodeId i = 0; i < rest_.size(); ++i)
    if (node_live_[i]) ids.push_back(i);
  return ids;
}

std::vector<TetId> TetComplex::tet_ids() const {
  std::vector<TetId> ids;
  ids.reserve(live_tets_);
  for (TetId t = 0; t < tet_.size(); ++t)
    if (tet_live_[t]) ids.push_back(t);
  return ids;
}

TetMesh TetComplex::mesh() const {
  TetMesh mesh;
  std::vector<std::uint32_t> index(rest_.size(), 0);
  mesh.positions.reserve(live_nodes_);
  for (const NodeId i : node_ids()) {
    index[i] = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(rest_[i]);
  }
  mesh.tets.reserve(live_tets_);
  for (const TetId t : tet_ids()) {
    const Corners& c = tet_[t];
    mesh.tets.push_back({index[c[0]], index[c[1]], index[c[2]], index[c[3]]});
  }
  return mesh;
}

}  // namespace prosector
