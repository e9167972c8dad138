#include "server/physics/cutting/tet_complex.h"

#include <utility>
#include <variant>

#include "common/anatomy/fabric.h"
#include "common/anatomy/mesh_quality.h"
#include "common/assert.h"
#include "common/error.h"
#include "common/hash.h"

namespace prosector {

TetComplex::TetComplex(TetTables tables, NodeMasses masses)
    : tables_(std::move(tables)), masses_(std::move(masses)) {
  connect(tables_);
}

TetComplex::TetComplex(const TetMesh& rest, double density)
    : TetComplex(tables_of(rest), NodeMasses(density)) {
  masses_.start(tables_);
}

TetComplex TetComplex::of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held) {
  TetComplex out(tables_of_sheet(sheet), NodeMasses(density));
  out.masses_.start_sheet(sheet_node_volumes(sheet), std::move(held));
  return out;
}

void TetComplex::finish() {
  std::fill(node_live_.begin(), node_live_.end(), std::uint8_t{1});
  for (NodeId node = 0; node < rest_.size(); ++node) origin_[node] = {node, node, 0};
  live_nodes_ = rest_.size();
  live_tets_ = tet_.size();
  std::vector<std::size_t> around(rest_.size(), 0);
  for (TetId t = 0; t < tet_.size(); ++t)
    for (const NodeId node : corners(t)) {
      if (node >= rest_.size())
        throw InputError(
            fmt::format("cutting: tetrahedron {} names node {}; there are {}", t, node, rest_.size()));
      ++around[node];
    }
  // With room for what cuts add.
  for (NodeId node = 0; node < star_.size(); ++node) star_[node].reserve(around[node] + around[node] / 2);
  for (TetId t = 0; t < tet_.size(); ++t) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < sides_; ++k) {
      const NodeId node = tet_[t].corner[k];
      star_[node].push_back(t);
      x[k] = rest_[node];
    }
    tet_[t].live = true;
    tet_[t].place = t;
    tet_[t].volume = size(std::span(x).first(sides_));
    if (!(tet_[t].volume > 0))
      throw InputError(fmt::format("cutting: tetrahedron {} has a rest volume of {} m³; allowed: positive", t,
                                   tet_[t].volume));
  }
  double volume = 0;
  for (const Tet& tet : tet_) volume += tet.volume;
  if (live_tets_ > 0) mean_volume_ = volume / static_cast<double>(live_tets_);
  cell_ = is_sheet() ? std::sqrt(4 / std::sqrt(3.0) * mean_volume_ / thickness_)
                     : std::cbrt(6 * std::sqrt(2.0) * mean_volume_);
  join_by_faces();
}

double TetComplex::size(std::span<const Vec3> x) const {
  if (is_sheet()) return thickness_ * (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  return tet_volume(x[0], x[1], x[2], x[3]);
}

// Faces in rows by their lowest node; a row is a few dozens long, and looked through for each face.
void TetComplex::join_by_faces() {
  struct Side {
    std::uint64_t others;  // the two other nodes
    TetId tet, joined;     // joined: the second that has this face
    std::uint32_t k;
  };
  const auto sorted = [&](TetId t, std::size_t k) {
    const Corners& c = tet_[t].corner;
    std::array<NodeId, 3> key = {c[face[k][0]], c[face[k][1]], c[face[k][2]]};
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    if (key[1] > key[2]) std::swap(key[1], key[2]);
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    return key;
  };
  std::vector<std::uint32_t> begin(rest_.size() + 1, 0);
  for (TetId t = 0; t < tet_.size(); ++t)
    for (std::size_t k = 0; k < sides_; ++k) ++begin[sorted(t, k)[0] + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
  std::vector<Side> sides(begin.back());
  for (TetId t = 0; t < tet_.size(); ++t)
    for (std::uint32_t k = 0; k < sides_; ++k) {
      const auto [lowest, middle, highest] = sorted(t, k);
      const std::uint64_t others = std::uint64_t{middle} << 32 | highest;
      Side* const last = sides.data() + end[lowest];
      Side* const same = std::find_if(sides.data() + begin[lowest], last,
                                      [&](const Side& side) { return side.others == others; });
      if (same == last) {
        *last = {others, t, none, k};
        ++end[lowest];
        continue;
      }
      if (same->joined != none)
        throw InputError(
            fmt::format("cutting: tetrahedra {}, {} and {} have one face in common; allowed: two", same->tet,
                        same->joined, t));
      same->joined = t;
      tet_[t].beyond[k] = same->tet;
      tet_[same->tet].beyond[same->k] = t;
    }
}

void TetComplex::grow_nodes(std::size_t end) {
  if (end <= rest_.size()) return;
  rest_.resize(end, Vec3::Zero());
  mass_.resize(end, 0.0);
  held_.resize(end, 0);
  origin_.resize(end);
  node_live_.resize(end, 0);
  stale_.resize(end, 0);
  star_.resize(end);
}

void TetComplex::grow_tets(std::size_t end) {
  if (end <= tet_.size()) return;
  tet_.resize(end);
}

bool TetComplex::has_corner(TetId tet, NodeId node) const {
  return corner_index(tet, node) < 4;
}

std::size_t TetComplex::corner_index(TetId tet, NodeId node) const {
  const Corners& c = tet_[tet].corner;
  for (std::size_t k = 0; k < sides_; ++k)
    if (c[k] == node) return k;
  return 4;
}

void TetComplex::around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const {
  tets.clear();
  const TetId *i = star_[a].data(), *j = star_[b].data();
  const TetId *const last_i = i + star_[a].size(), *const last_j = j + star_[b].size();
  while (i != last_i && j != last_j) {
    const TetId of_a = *i, of_b = *j;
    if (of_a == of_b) tets.push_back(of_a);
    i += of_a <= of_b;
    j += of_b <= of_a;
  }
}

std::size_t TetComplex::slot_towards(TetId tet, TetId other) const {
  for (std::size_t k = 0; k < 4; ++k)
    if (tet_[tet].beyond[k] == other) return k;
  return 4;
}

std::size_t TetComplex::slot_of_face(TetId tet, TetId other) const {
  std::size_t slot = 4, apart = 0;
  for (std::size_t k = 0; k < sides_; ++k)
    if (!has_corner(other, tet_[tet].corner[k])) {
      slot = k;
      ++apart;
    }
  return apart == 1 ? slot : 4;
}

void TetComplex::leave(NodeId node, TetId tet) {
  auto& star = star_[node];
  star.erase(std::lower_bound(star.begin(), star.end(), tet));
}

void TetComplex::leave_all(NodeId node, std::span<const TetId> tets) {
  PROSECTOR_ASSERT(node < star_.size() && is_ascending(tets) && is_ascending(star_[node]));
  auto next = tets.begin();
  std::erase_if(star_[node], [&](TetId t) {
    const bool leaves = next != tets.end() && *next == t;
    next += leaves;
    return leaves;
  });
}

void TetComplex::enter(NodeId node, TetId tet) {
  PROSECTOR_ASSERT(node < star_.size() && tet < tet_.size() && !std::ranges::binary_search(star_[node], tet));
  auto& star = star_[node];
  star.insert(std::lower_bound(star.begin(), star.end(), tet), tet);
}

void TetComplex::update_mass(NodeId node) {
  if (!masses_held_) return find_mass(node);
  if (!stale_[node]) unsettled_.push_back(node);
  stale_[node] = 1;
}

void TetComplex::settle_masses() {
  masses_held_ = false;
  for (const NodeId node : unsettled_) {
    find_mass(node);
    stale_[node] = 0;
  }
  unsettled_.clear();
}

// Summed in the order of ids, so that it is the same however the star came about.
void TetComplex::find_mass(NodeId node) {
  double volume = 0;
  for (const TetId t : star_[node]) volume += tet_[t].volume;
  mass_[node] = density_ * volume / 4;
}

void TetComplex::update_masses_of(std::span<const TetId> tets) {
  if (masses_held_) {
    for (const TetId t : tets)
      for (const NodeId node : tet_[t].corner) update_mass(node);
    return;
  }
  met_.clear();
  for (const TetId t : tets)
    for (const NodeId node : tet_[t].corner)
      if (std::find(met_.begin(), met_.end(), node) == met_.end()) met_.push_back(node);
  for (const NodeId node : met_) update_mass(node);
}

void TetComplex::apply(const TopologyOp& op) {
  std::visit([&](const auto& o) { prosector::apply(o, EditedTables{tables_, masses_, scratch_}); }, op);
}

void TetComplex::take_back(const TopologyOp& op) {
  std::visit([&](const auto& o) { prosector::take_back(o, EditedTables{tables_, masses_, scratch_}); }, op);
  ++undone_;
}

void TetComplex::continue_from(const TetComplex& later) {
  tables_.grow_nodes(later.node_end());
  masses_.grow(later.node_end());
  tables_.grow_tets(later.tet_end());
  undone_ = later.undone_ + 1;
}

std::uint64_t content_hash(const TetComplex& complex) {
  StateHasher hash;
  hash.add(complex.density());
  for (NodeId i = 0; i < complex.node_end(); ++i) {
    if (!complex.has_node(i)) continue;
    hash.add(i);
    hash.add(complex.rest(i).data(), 3);
    hash.add(complex.mass(i));
  }
  for (TetId t = 0; t < complex.tet_end(); ++t) {
    if (!complex.has_tet(t)) continue;
    const TetTables::Tet& tet = complex.tables().tet[t];
    hash.add(t);
    hash.add(std::as_bytes(std::span(tet.corner)));
    hash.add(std::as_bytes(std::span(tet.beyond)));
    hash.add(tet.wall);
  }
  return hash.digest();
}

std::vector<NodeId> node_ids(const TetComplex& complex) {
  std::vector<NodeId> ids;
  ids.reserve(complex.nodes());
  for (NodeId i = 0; i < complex.node_end(); ++i)
    if (complex.has_node(i)) ids.push_back(i);
  return ids;
}

std::vector<TetId> tet_ids(const TetComplex& complex) {
  std::vector<TetId> ids;
  ids.reserve(complex.tets());
  for (TetId t = 0; t < complex.tet_end(); ++t)
    if (complex.has_tet(t)) ids.push_back(t);
  return ids;
}

}  // namespace prosector
