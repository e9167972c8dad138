// TetComplex's three elementary changes, each beside its inverse.

#include <fmt/format.h>

#include <algorithm>

#include "common/anatomy/mesh_quality.h"
#include "common/error.h"
#include "server/physics/cutting/tet_complex.h"

namespace prosector {
namespace {

void require(bool ok, std::string_view what) {
  if (!ok) throw InputError(fmt::format("cutting: {}", what));
}

}  // namespace

void TetComplex::change(const SplitEdge& op) {
  require(op.a != op.b && has_node(op.a) && has_node(op.b), "an edge to split has no such nodes");
  require(op.t > 0 && op.t < 1, "an edge is split outside (0, 1)");
  require(op.node >= node_end() && op.first >= tet_end(), "an edge's splitting brings ids that were used");
  around_edge(op.a, op.b, around_);
  require(!around_.empty() && around_.size() == op.count,
          "an edge to split has another number of tetrahedra");
  require(op.node - node_end() <= tet_end() && op.first - tet_end() <= 8 * (tet_end() + 8),
          "an edge's splitting brings ids far beyond those used");
  const Vec3 middle = rest_[op.a] + (rest_[op.b] - rest_[op.a]) * op.t;
  const auto volume_with = [&](TetId t, NodeId gone) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < sides_; ++k)
      x[k] = tet_[t].corner[k] == gone ? middle : rest_[tet_[t].corner[k]];
    return size(std::span(x).first(sides_));
  };
  halves_.clear();
  for (const TetId t : around_) {
    halves_.push_back({volume_with(t, op.b), volume_with(t, op.a)});
    require(halves_.back()[0] > 0 && halves_.back()[1] > 0, "an edge's splitting makes no volume");
  }

  grow_nodes(op.node + 1u);
  grow_tets(op.first + 2u * op.count);
  rest_[op.node] = middle;
  origin_[op.node] = {op.a, op.b, op.t};
  node_live_[op.node] = 1;
  ++live_nodes_;
  live_tets_ += op.count;
  leave_all(op.a, around_);
  leave_all(op.b, around_);
  star_[op.node].reserve(2 * around_.size());
  for (std::size_t i = 0; i < around_.size(); ++i) {
    const TetId t = around_[i], with_a = op.first + 2 * static_cast<TetId>(i), with_b = with_a + 1;
    const std::size_t ka = corner_index(t, op.a), kb = corner_index(t, op.b);
    Tet &whole = tet_[t], &a = tet_[with_a], &b = tet_[with_b];
    a.corner = b.corner = whole.corner;
    a.corner[kb] = b.corner[ka] = op.node;
    a.volume = halves_[i][0];
    b.volume = halves_[i][1];
    a.wall = static_cast<std::uint8_t>(whole.wall & ~(1u << ka));
    b.wall = static_cast<std::uint8_t>(whole.wall & ~(1u << kb));
    a.parent = b.parent = t;
    a.place = whole.place;
    b.place = with_b;
    whole.child = with_a;
    whole.live = false;
    a.live = b.live = true;
    for (std::size_t k = 0; k < sides_; ++k) {
      const TetId beyond = whole.beyond[k];
      if (k == ka) {
        a.beyond[k] = with_b;
        b.beyond[k] = beyond;
        if (beyond != none) tet_[beyond].beyond[slot_towards(beyond, t)] = with_b;
      } else if (k == kb) {
        b.beyond[k] = with_a;
        a.beyond[k] = beyond;
        if (beyond != none) tet_[beyond].beyond[slot_towards(beyond, t)] = with_a;
      } else if (beyond == none) {
        a.beyond[k] = b.beyond[k] = none;
      } else {
        const auto j = std::lower_bound(around_.begin(), around_.end(), beyond) - around_.begin();
        a.beyond[k] = op.first + 2 * static_cast<TetId>(j);
        b.beyond[k] = a.beyond[k] + 1;
      }
    }
    for (const NodeId node : corners(t))
      if (node != op.a && node != op.b) leave(node, t);
    for (const NodeId node : corners(with_a)) star_[node].push_back(with_a);
    for (const NodeId node : corners(with_b)) star_[node].push_back(with_b);
  }
  if (is_sheet()) return share_mass(op);
  update_masses_of(around_);
  update_mass(op.node);
}

void TetComplex::change_back(const SplitEdge& op) {
  bool good = op.count > 0 && has_node(op.node) && op.first + 2ull * op.count <= tet_end() &&
              star_[op.node].size() == 2ull * op.count;
  for (TetId c = op.first; good && c < op.first + 2 * op.count; ++c)
    good = has_tet(c) && tet_[c].parent != none;
  require(good, "an edge's splitting to take back isn't there as it was made");
  for (TetId i = 0; i < op.count; ++i) {
    const TetId with_a = op.first + 2 * i, with_b = with_a + 1, t = tet_[with_a].parent;
    const std::size_t ka = corner_index(t, op.a), kb = corner_index(t, op.b);
    for (const auto& [child, k] : {std::pair{with_a, kb}, std::pair{with_b, ka}}) {
      const TetId beyond = tet_[child].beyond[k];
      tet_[t].beyond[k] = beyond;
      if (beyond != none) tet_[beyond].beyond[slot_towards(beyond, child)] = t;
      for (const NodeId node : corners(child)) leave(node, child);
      tet_[child].live = false;
    }
    for (const NodeId node : corners(t)) enter(node, t);
    tet_[t].live = true;
    tet_[t].child = none;
  }
  node_live_[op.node] = 0;
  --live_nodes_;
  live_tets_ -= op.count;
  if (is_sheet()) return share_back(op);
  around_.clear();
  for (TetId i = 0; i < op.count; ++i) around_.push_back(tet_[op.first + 2 * i].parent);
  update_masses_of(around_);
}

void TetComplex::change(const SlitFaces& op) {
  for (std::size_t i = 0; i < op.faces.size(); ++i) {
    const auto& [a, b] = op.faces[i];
    require(a < b && (i == 0 || op.faces[i - 1] < op.faces[i]), "faces to slit are not in order");
    require(has_tet(a) && has_tet(b) && slot_towards(a, b) < 4, "faces to slit join no such tetrahedra");
  }
  for (const auto& [a, b] : op.faces) {
    const std::size_t ka = slot_towards(a, b), kb = slot_towards(b, a);
    tet_[a].beyond[ka] = tet_[b].beyond[kb] = none;
    tet_[a].wall = static_cast<std::uint8_t>(tet_[a].wall | 1u << ka);
    tet_[b].wall = static_cast<std::uint8_t>(tet_[b].wall | 1u << kb);
  }
}

void TetComplex::change_back(const SlitFaces& op) {
  for (const auto& [a, b] : op.faces) {
    require(has_tet(a) && has_tet(b), "faces to join belong to no such tetrahedra");
    const std::size_t ka = slot_of_face(a, b), kb = slot_of_face(b, a);
    require(ka < 4 && kb < 4 && is_wall(a, ka) && is_wall(b, kb), "faces to join were not slit");
  }
  for (const auto& [a, b] : op.faces) {
    const std::size_t ka = slot_of_face(a, b), kb = slot_of_face(b, a);
    tet_[a].beyond[ka] = b;
    tet_[b].beyond[kb] = a;
    tet_[a].wall = static_cast<std::uint8_t>(tet_[a].wall & ~(1u << ka));
    tet_[b].wall = static_cast<std::uint8_t>(tet_[b].wall & ~(1u << kb));
  }
}

void TetComplex::check_parting(const PartNode& op) const {
  require(has_node(op.node), "a node to part isn't there");
  std::vector<TetId> taken;
  NodeId last = static_cast<NodeId>(node_end() - 1);
  for (const auto& copy : op.copies) {
    require(copy.node > last && copy.node - node_end() <= tet_end(),
            "a parted node's copies bring wrong ids");
    last = copy.node;
    require(!copy.tets.empty() && std::is_sorted(copy.tets.begin(), copy.tets.end()),
            "a parted node's copy has no tetrahedra in order");
    taken.insert(taken.end(), copy.tets.begin(), copy.tets.end());
    for (const TetId t : copy.tets) {
      require(has_tet(t) && has_corner(t, op.node), "a parted node's copy takes what isn't the node's");
      for (std::size_t k = 0; k < sides_; ++k) {
        const TetId beyond = tet_[t].beyond[k];
        require(beyond == none || tet_[t].corner[k] == op.node ||
                    std::binary_search(copy.tets.begin(), copy.tets.end(), beyond),
                "a parted node's copy would tear a face");
      }
    }
  }
  if (op.copies.size() > 1) std::sort(taken.begin(), taken.end());
  require(std::adjacent_find(taken.begin(), taken.end()) == taken.end(), "two copies take one tetrahedron");
  require(!op.copies.empty() && taken.size() < star_[op.node].size(), "a parted node keeps no tetrahedron");
}

void TetComplex::change(const PartNode& op) {
  check_parting(op);
  grow_nodes(op.copies.back().node + 1u);
  for (const auto& copy : op.copies) {
    rest_[copy.node] = rest_[op.node];
    origin_[copy.node] = {op.node, op.node, 0};
    node_live_[copy.node] = 1;
    ++live_nodes_;
    leave_all(op.node, copy.tets);
    for (const TetId t : copy.tets) tet_[t].corner[corner_index(t, op.node)] = copy.node;
    star_[copy.node] = copy.tets;
    if (!is_sheet()) update_mass(copy.node);
  }
  if (is_sheet()) return share_mass(op);
  update_mass(op.node);
}

void TetComplex::change_back(const PartNode& op) {
  require(has_node(op.node), "a node to join again isn't there");
  for (const auto& copy : op.copies)
    require(has_node(copy.node) && star_[copy.node] == copy.tets, "a node's copies aren't as they were made");
  for (const auto& copy : op.copies) {
    for (const TetId t : copy.tets) {
      tet_[t].corner[corner_index(t, copy.node)] = op.node;
      enter(op.node, t);
    }
    star_[copy.node].clear();
    node_live_[copy.node] = 0;
    --live_nodes_;
  }
  if (is_sheet()) return share_back(op);
  update_mass(op.node);
}

}  // namespace prosector
