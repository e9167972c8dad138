#include "server/physics/mechanics/cutting/topology_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "common/assert.h"
#include "common/error.h"

namespace prosector::cutting {
namespace {

constexpr TetId none = TetTables::none;

void require(bool ok, std::string_view what) {
  if (!ok) throw InputError(fmt::format("cutting: {}", what));
}

void grow_nodes(EditedTables edited, std::size_t end) {
  edited.tables.grow_nodes(end);
  edited.masses.grow(end);
}

/// Returns the rest position of an edge's new node, m.
Vec3 middle_of(const SplitEdge& op, const TetTables& tables) {
  PROSECTOR_ASSERT(tables.has_node(op.a) && tables.has_node(op.b));
  return tables.rest[op.a] + (tables.rest[op.b] - tables.rest[op.a]) * op.t;
}

/// Checks an edge split. Fills `scratch` with the tetrahedra around the edge and the volumes of their halves.
void check_split(const SplitEdge& op, const TetTables& tables, EdgeScratch& scratch) {
  const std::size_t node_end = tables.rest.size(), tet_end = tables.tet.size();
  require(op.a != op.b && tables.has_node(op.a) && tables.has_node(op.b),
          "the edge to split has two equal or nonexistent nodes; allowed: two different nodes of the mesh");
  require(op.t > 0 && op.t < 1,
          "the position at which an edge is split is not a fraction between 0 and 1 of its length");
  require(op.node >= node_end && op.first >= tet_end,
          "the new node or new tetrahedra of an edge split have ids that are already used");
  tables.around_edge(op.a, op.b, scratch.around);
  require(!scratch.around.empty() && scratch.around.size() == op.count,
          "an edge split records another number of tetrahedra around the edge than the mesh has there");
  require(op.node - node_end <= tet_end && op.first - tet_end <= 8 * (tet_end + 8),
          "the new node or new tetrahedra of an edge split have ids out of range");
  const Vec3 middle = middle_of(op, tables);
  const auto volume_with = [&](TetId t, NodeId gone) {
    std::array<Vec3, 4> x;
    for (std::size_t k = 0; k < tables.sides; ++k)
      x[k] = tables.tet[t].corner[k] == gone ? middle : tables.rest[tables.tet[t].corner[k]];
    return tables.volume_of(std::span(x).first(tables.sides));
  };
  scratch.halves.clear();
  for (const TetId t : scratch.around) {
    scratch.halves.push_back({volume_with(t, op.b), volume_with(t, op.a)});
    require(scratch.halves.back()[0] > 0 && scratch.halves.back()[1] > 0,
            "an edge split creates tetrahedra without volume; allowed: positive volumes");
  }
}

/// Connects the halves of t, the first of which is `with_a`, to each other and to the neighbours of t. The
/// neighbours around the edge (`around`, ascending) are all split.
void join_halves(const SplitEdge& op, TetTables& tables, std::span<const TetId> around, TetId t,
                 TetId with_a) {
  const TetId with_b = with_a + 1;
  const std::size_t ka = tables.corner_index(t, op.a), kb = tables.corner_index(t, op.b);
  PROSECTOR_ASSERT(ka < tables.sides && kb < tables.sides && ka != kb && is_ascending(around));
  TetTables::Tet &a = tables.tet[with_a], &b = tables.tet[with_b];
  for (std::size_t k = 0; k < tables.sides; ++k) {
    const TetId beyond = tables.tet[t].beyond[k];
    if (k == ka) {
      a.beyond[k] = with_b;
      b.beyond[k] = beyond;
      if (beyond != none) tables.tet[beyond].beyond[tables.face_towards(beyond, t)] = with_b;
    } else if (k == kb) {
      b.beyond[k] = with_a;
      a.beyond[k] = beyond;
      if (beyond != none) tables.tet[beyond].beyond[tables.face_towards(beyond, t)] = with_a;
    } else if (beyond == none) {
      a.beyond[k] = b.beyond[k] = none;
    } else {
      const auto j = std::lower_bound(around.begin(), around.end(), beyond) - around.begin();
      PROSECTOR_ASSERT(j < std::ssize(around) && around[static_cast<std::size_t>(j)] == beyond);
      a.beyond[k] = op.first + 2 * static_cast<TetId>(j);
      b.beyond[k] = a.beyond[k] + 1;
    }
  }
}

/// Replaces t by two halves of these volumes, m³.
void split_tet(const SplitEdge& op, TetTables& tables, TetId t, TetId with_a,
               const std::array<double, 2>& volumes) {
  const TetId with_b = with_a + 1;
  const std::size_t ka = tables.corner_index(t, op.a), kb = tables.corner_index(t, op.b);
  PROSECTOR_ASSERT(tables.has_tet(t) && !tables.has_tet(with_a) && !tables.has_tet(with_b) &&
                   with_b < tables.tet.size());
  PROSECTOR_ASSERT(volumes[0] > 0 && volumes[1] > 0);
  TetTables::Tet &whole = tables.tet[t], &a = tables.tet[with_a], &b = tables.tet[with_b];
  a.corner = b.corner = whole.corner;
  a.corner[kb] = b.corner[ka] = op.node;
  a.volume = volumes[0];
  b.volume = volumes[1];
  a.wall = static_cast<std::uint8_t>(whole.wall & ~(1u << ka));
  b.wall = static_cast<std::uint8_t>(whole.wall & ~(1u << kb));
  a.lineage.parent = b.lineage.parent = t;
  a.lineage.place = whole.lineage.place;
  b.lineage.place = with_b;
  whole.lineage.child = with_a;
  whole.live = false;
  a.live = b.live = true;
  for (const NodeId node : tables.corners(t))
    if (node != op.a && node != op.b) tables.leave(node, t);
  for (const NodeId node : tables.corners(with_a)) tables.star[node].push_back(with_a);
  for (const NodeId node : tables.corners(with_b)) tables.star[node].push_back(with_b);
}

/// Checks a node duplication: no copy may separate two tetrahedra with a common face, and the node must keep
/// some tetrahedra.
void check_parting(const PartNode& op, const TetTables& tables) {
  require(tables.has_node(op.node), "the node to split does not exist in the mesh");
  std::vector<TetId> taken;
  const std::size_t node_end = tables.rest.size();
  NodeId last = static_cast<NodeId>(node_end - 1);
  for (const auto& copy : op.copies) {
    require(copy.node > last && copy.node - node_end <= tables.tet.size(),
            "the copies of a split node have ids that are already used, not ascending, or out of range");
    last = copy.node;
    require(!copy.tets.empty() && std::is_sorted(copy.tets.begin(), copy.tets.end()),
            "the list of tetrahedra of a split node's copy is empty or not sorted by id");
    taken.insert(taken.end(), copy.tets.begin(), copy.tets.end());
    for (const TetId t : copy.tets) {
      require(tables.has_tet(t) && tables.corner_index(t, op.node) < 4,
              "the copy of a split node lists tetrahedra that do not exist or do not have the split node as "
              "a corner");
      for (std::size_t k = 0; k < tables.sides; ++k) {
        const TetId beyond = tables.tet[t].beyond[k];
        require(beyond == none || tables.tet[t].corner[k] == op.node ||
                    std::binary_search(copy.tets.begin(), copy.tets.end(), beyond),
                "the copy of a split node takes only one of two tetrahedra that are still joined by a face; "
                "it must take both");
      }
    }
  }
  if (op.copies.size() > 1) std::sort(taken.begin(), taken.end());
  require(std::adjacent_find(taken.begin(), taken.end()) == taken.end(),
          "two copies of a split node list the same tetrahedron; allowed: each tetrahedron in one copy");
  require(!op.copies.empty() && taken.size() < tables.star[op.node].size(),
          "the copies of a split node take all its tetrahedra, or there are no copies; the node must keep at "
          "least one tetrahedron");
}

}  // namespace

void apply(const SplitEdge& op, EditedTables edited) {
  auto& [tables, masses, scratch] = edited;
  check_split(op, tables, scratch);
  const Vec3 middle = middle_of(op, tables);
  grow_nodes(edited, op.node + 1u);
  tables.grow_tets(op.first + 2u * op.count);
  tables.rest[op.node] = middle;
  tables.origin[op.node] = {op.a, op.b, op.t};
  tables.node_live[op.node] = 1;
  ++tables.live_nodes;
  tables.live_tets += op.count;
  const std::span<const TetId> around = scratch.around;
  PROSECTOR_ASSERT(is_ascending(around) && scratch.halves.size() == around.size() &&
                   tables.star[op.node].empty());
  tables.leave_all(op.a, around);
  tables.leave_all(op.b, around);
  tables.star[op.node].reserve(2 * around.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const TetId with_a = op.first + 2 * static_cast<TetId>(i);
    split_tet(op, tables, around[i], with_a, scratch.halves[i]);
    join_halves(op, tables, around, around[i], with_a);
  }
  PROSECTOR_ASSERT(tables.star[op.node].size() == 2 * around.size() && is_ascending(tables.star[op.node]));
  if (tables.is_sheet()) return masses.share(op);
  masses.update_around(tables, around);
  masses.update(tables, op.node);
}

void take_back(const SplitEdge& op, EditedTables edited) {
  auto& [tables, masses, scratch] = edited;
  bool good = op.count > 0 && tables.has_node(op.node) && op.first + 2ull * op.count <= tables.tet.size() &&
              tables.star[op.node].size() == 2ull * op.count;
  for (TetId c = op.first; good && c < op.first + 2 * op.count; ++c)
    good = tables.has_tet(c) && tables.tet[c].lineage.parent != none;
  require(good, "an edge split cannot be undone, because its new node and tetrahedra do not match the mesh");
  for (TetId i = 0; i < op.count; ++i) {
    const TetId with_a = op.first + 2 * i, with_b = with_a + 1, t = tables.tet[with_a].lineage.parent;
    const std::size_t ka = tables.corner_index(t, op.a), kb = tables.corner_index(t, op.b);
    for (const auto& [child, k] : {std::pair{with_a, kb}, std::pair{with_b, ka}}) {
      const TetId beyond = tables.tet[child].beyond[k];
      tables.tet[t].beyond[k] = beyond;
      if (beyond != none) tables.tet[beyond].beyond[tables.face_towards(beyond, child)] = t;
      for (const NodeId node : tables.corners(child)) tables.leave(node, child);
      tables.tet[child].live = false;
    }
    for (const NodeId node : tables.corners(t)) tables.enter(node, t);
    tables.tet[t].live = true;
    tables.tet[t].lineage.child = none;
  }
  tables.node_live[op.node] = 0;
  --tables.live_nodes;
  tables.live_tets -= op.count;
  if (tables.is_sheet()) return masses.share_back(op);
  scratch.around.clear();
  for (TetId i = 0; i < op.count; ++i) scratch.around.push_back(tables.tet[op.first + 2 * i].lineage.parent);
  masses.update_around(tables, scratch.around);
}

void apply(const SlitFaces& op, EditedTables edited) {
  TetTables& tables = edited.tables;
  for (std::size_t i = 0; i < op.faces.size(); ++i) {
    const auto& [a, b] = op.faces[i];
    require(a < b && (i == 0 || op.faces[i - 1] < op.faces[i]),
            "the faces to separate are not sorted by the ids of their two tetrahedra");
    require(tables.has_tet(a) && tables.has_tet(b) && tables.face_towards(a, b) < 4,
            "a face to separate is given by two tetrahedra that do not exist or have no common face");
  }
  for (const auto& [a, b] : op.faces) {
    const std::size_t ka = tables.face_towards(a, b), kb = tables.face_towards(b, a);
    PROSECTOR_ASSERT(ka < tables.sides && kb < tables.sides);
    TetTables::Tet &of_a = tables.tet[a], &of_b = tables.tet[b];
    of_a.beyond[ka] = of_b.beyond[kb] = none;
    of_a.wall = static_cast<std::uint8_t>(of_a.wall | 1u << ka);
    of_b.wall = static_cast<std::uint8_t>(of_b.wall | 1u << kb);
  }
}

void take_back(const SlitFaces& op, EditedTables edited) {
  TetTables& tables = edited.tables;
  const auto is_wall = [&](TetId t, std::size_t k) { return (tables.tet[t].wall >> k & 1) != 0; };
  for (const auto& [a, b] : op.faces) {
    require(tables.has_tet(a) && tables.has_tet(b),
            "a face to rejoin is given by a tetrahedron that does not exist");
    const std::size_t ka = tables.face_shared(a, b), kb = tables.face_shared(b, a);
    require(ka < 4 && kb < 4 && is_wall(a, ka) && is_wall(b, kb),
            "a face to rejoin had not been separated by a cut");
  }
  for (const auto& [a, b] : op.faces) {
    const std::size_t ka = tables.face_shared(a, b), kb = tables.face_shared(b, a);
    TetTables::Tet &of_a = tables.tet[a], &of_b = tables.tet[b];
    of_a.beyond[ka] = b;
    of_b.beyond[kb] = a;
    of_a.wall = static_cast<std::uint8_t>(of_a.wall & ~(1u << ka));
    of_b.wall = static_cast<std::uint8_t>(of_b.wall & ~(1u << kb));
  }
}

void apply(const PartNode& op, EditedTables edited) {
  auto& [tables, masses, scratch] = edited;
  check_parting(op, tables);
  grow_nodes(edited, op.copies.back().node + 1u);
  for (const auto& copy : op.copies) {
    PROSECTOR_ASSERT(!tables.has_node(copy.node) && tables.star[copy.node].empty());
    tables.rest[copy.node] = tables.rest[op.node];
    tables.origin[copy.node] = {op.node, op.node, 0};
    tables.node_live[copy.node] = 1;
    ++tables.live_nodes;
    tables.leave_all(op.node, copy.tets);
    for (const TetId t : copy.tets) tables.tet[t].corner[tables.corner_index(t, op.node)] = copy.node;
    tables.star[copy.node] = copy.tets;
    if (!tables.is_sheet()) masses.update(tables, copy.node);
  }
  PROSECTOR_ASSERT(!tables.star[op.node].empty());
  if (tables.is_sheet()) return masses.share(tables, op);
  masses.update(tables, op.node);
}

void take_back(const PartNode& op, EditedTables edited) {
  auto& [tables, masses, scratch] = edited;
  require(tables.has_node(op.node), "the node whose split is to be undone does not exist in the mesh");
  for (const auto& copy : op.copies)
    require(tables.has_node(copy.node) && tables.star[copy.node] == copy.tets,
            "a node split cannot be undone, because the node's copies do not match the mesh");
  for (const auto& copy : op.copies) {
    for (const TetId t : copy.tets) {
      tables.tet[t].corner[tables.corner_index(t, copy.node)] = op.node;
      tables.enter(op.node, t);
    }
    tables.star[copy.node].clear();
    tables.node_live[copy.node] = 0;
    --tables.live_nodes;
  }
  if (tables.is_sheet()) return masses.share_back(op);
  masses.update(tables, op.node);
}

}  // namespace prosector::cutting
