#pragma once
// Tetrahedra, or the triangles of a sheet, that can be cut: who neighbours whom, kept up to date locally. The
// rest shape only; positions of the moving body are the caller's, by node id. What is said of tetrahedra and
// their faces holds for triangles and their edges, but for their masses (sheet_mass.h).

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "server/physics/cutting/topology_op.h"

namespace prosector {

class TetComplex {
 public:
  using Corners = std::array<NodeId, 4>;
  static constexpr TetId none = std::numeric_limits<TetId>::max();

  /// `rest`: every tetrahedron of positive volume, at most two at a face. `density`: kg/m³. Throws
  /// InputError that names the tetrahedron otherwise.
  TetComplex(const TetMesh& rest, double density);
  /// Of a sheet that was never cut: of its i-th cell a, b, c, d triangles 2i (a, b, c) and 2i + 1 (a, c, d).
  /// `held`: by node, what is tied to its place; empty: nothing.
  static TetComplex of_sheet(const Anatomy& sheet, double density, std::vector<std::uint8_t> held);

  // ---- By id. Ids of nodes and tetrahedra that are gone stay unused.
  std::size_t node_end() const { return rest_.size(); }  // one past the largest id ever used
  std::size_t tet_end() const { return tet_.size(); }
  std::size_t nodes() const { return live_nodes_; }
  std::size_t tets() const { return live_tets_; }
  bool has_node(NodeId node) const { return node < rest_.size() && node_live_[node]; }
  bool has_tet(TetId tet) const { return tet < tet_.size() && tet_[tet].live; }
  const Vec3& rest(NodeId node) const { return rest_[node]; }             // m
  double mass(NodeId node) const { return mass_[node]; }                  // kg: ρV/4 of its tetrahedra
  bool is_held(NodeId node) const { return held_[node] != 0; }            // of sheets: tied to its place
  std::span<const TetId> star(NodeId node) const { return star_[node]; }  // ascending
  std::size_t sides() const { return sides_; }                            // of one: 4; 3 of triangles
  bool is_sheet() const { return sides_ == 3; }
  /// As many; kept of tetrahedra that were split.
  std::span<const NodeId> corners(TetId tet) const { return {tet_[tet].corner.data(), sides_}; }
  double volume(TetId tet) const { return tet_[tet].volume; }  // m³ at rest
  /// The tetrahedron across the face opposite corner k; none at the boundary.
  TetId neighbor(TetId tet, std::size_t k) const { return tet_[tet].beyond[k]; }
  /// Whether the face opposite corner k was made by a cut.
  bool is_wall(TetId tet, std::size_t k) const { return (tet_[tet].wall >> k & 1) != 0; }
  /// The first of the two that `tet` became (the other is the next id); none if it was never split.
  TetId child(TetId tet) const { return tet_[tet].child; }
  /// Which tetrahedron became this one; none for those of the compiled mesh.
  TetId parent(TetId tet) const { return tet_[tet].parent; }
  /// Of its ancestors and itself the first whose place it has: the first of the two that a tetrahedron
  /// becomes takes that one's, the second gets one of its own. Of live ones no two have the same, and a cut
  /// leaves each where it is.
  TetId place(TetId tet) const { return tet_[tet].place; }
  /// Where a cut put the node: at a + t·(b − a); a copy of a where that is b; of the compiled mesh itself.
  struct Origin {
    NodeId a = none, b = none;
    double t = 0;
  };
  const Origin& origin(NodeId node) const { return origin_[node]; }
  bool has_corner(TetId tet, NodeId node) const;
  std::size_t corner_index(TetId tet, NodeId node) const;  // 4: has none
  /// Tetrahedra with both nodes, ascending.
  void around_edge(NodeId a, NodeId b, std::vector<TetId>& tets) const;
  double density() const { return density_; }          // kg/m³
  double mean_volume() const { return mean_volume_; }  // m³, of the compiled mesh's tetrahedra
  double cell() const { return cell_; }                // m, edge of a regular one of that size
  std::uint64_t undone() const { return undone_; }     // how often something was taken back

  // ---- Changes. Both throw InputError, and change nothing, for what doesn't fit.
  /// Ids that `op` brings must be unused; splitting makes no tetrahedron of no volume.
  void apply(const TopologyOp& op);
  /// Masses of tetrahedra's nodes are found once, in settle_masses(), rather than after each change: they are
  /// sums over stars. Until then those of what changed are not up to date.
  void hold_masses() { masses_held_ = true; }
  void settle_masses();
  /// Undoes the op that was applied last of those not yet taken back: content_hash() is then what it was.
  void take_back(const TopologyOp& op);

  /// The same body's earlier state goes on where `later` was: ids that were used there are used.
  void continue_from(const TetComplex& later);

  /// Of connectivity, rest shape and masses, by id.
  std::uint64_t content_hash() const;
  /// Live node ids, ascending: the order of mesh().positions.
  std::vector<NodeId> node_ids() const;
  std::vector<TetId> tet_ids() const;
  TetMesh mesh() const;

  /// Corners of the face opposite corner k, counter-clockwise from outside.
  static constexpr std::array<std::array<std::size_t, 3>, 4> face = {
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

 private:
  void change(const SplitEdge& op);
  void change(const SlitFaces& op);
  void change(const PartNode& op);
  void change_back(const SplitEdge& op);
  void change_back(const SlitFaces& op);
  void change_back(const PartNode& op);
  explicit TetComplex(double density);
  void finish();                                     // what follows from cells and nodes
  double size(std::span<const Vec3> corners) const;  // m³
  void share_mass(const SplitEdge& op);
  void share_mass(const PartNode& op);
  void share_back(const SplitEdge& op);
  void share_back(const PartNode& op);
  void join_by_faces();
  void grow_nodes(std::size_t end);
  void grow_tets(std::size_t end);
  void leave(NodeId node, TetId tet);
  void leave_all(NodeId node, std::span<const TetId> tets);  // ascending
  void enter(NodeId node, TetId tet);
  void update_mass(NodeId node);
  void find_mass(NodeId node);
  void update_masses_of(std::span<const TetId> tets);      // around one edge
  std::size_t slot_towards(TetId tet, TetId other) const;  // by neighbour; 4: none
  std::size_t slot_of_face(TetId tet, TetId other) const;  // by three common corners; 4: none
  void check_parting(const PartNode& op) const;

  /// All that is known of one, in one place: what a cut looks at it takes together.
  struct Tet {
    Corners corner{};
    std::array<TetId, 4> beyond = {none, none, none, none};  // by face
    double volume = 0;                                       // m³
    TetId parent = none, child = none, place = none;
    std::uint8_t wall = 0;  // bit k: face k
    bool live = false;
  };
  /// Of a sheet's nodes before an operation, by the node that it brought (PartNode: its first).
  struct Shared {
    double a = 0, b = 0;  // kg; of a node that parted: a
  };

  std::size_t sides_ = 4;
  double thickness_ = 0;  // m, of a sheet
  double density_, mean_volume_ = 0, cell_ = 0;
  std::vector<Vec3> rest_;
  std::vector<double> mass_;
  std::vector<std::uint8_t> held_;  // by node
  std::vector<Origin> origin_;      // by node, gone ones too
  std::vector<Shared> shared_;      // by node, of sheets
  std::vector<std::uint8_t> node_live_;
  std::vector<std::vector<TetId>> star_;
  std::vector<Tet> tet_;
  std::vector<std::uint8_t> stale_;  // by node: masses to settle
  std::vector<NodeId> unsettled_;
  bool masses_held_ = false;
  std::vector<std::array<double, 2>> halves_;  // scratch
  std::vector<TetId> around_;                  // scratch
  std::vector<NodeId> met_;                    // scratch
  std::size_t live_nodes_ = 0, live_tets_ = 0;
  std::uint64_t undone_ = 0;
};

}  // namespace prosector
