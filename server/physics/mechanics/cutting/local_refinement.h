#pragma once
// Local refinement of a body's mesh where the body is touched, and coarsening after the contact has ended
// (docs/decisions/0025).
//
// Edges are bisected as in a cut, so the mesh stays conforming and keeps its rest shape, volume and mass. The
// choice of the edge preserves element quality: an edge is bisected only if it is the longest edge of all
// tetrahedra around it. If a neighbour has a longer edge, that edge is bisected first (Rivara 1997, "New
// longest-edge algorithms for the refinement and/or improvement of unstructured triangulations"). Ties are
// broken by lower ids. A bisection is undone if its halves are not split further, so the original mesh is
// restored in the end.

#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "common/mesh.h"
#include "server/physics/mechanics/cutting/tet_complex.h"
#include "server/physics/mechanics/cutting/touched_places.h"

namespace prosector::cutting {

struct RefinementLimits {
  double edge = 0;           // m: longest edge allowed near a touched place
  double reach = 0;          // m: distance from a touched place up to which tetrahedra are refined
  std::size_t most = 0;      // most tetrahedra that may be added to the compiled mesh
  std::uint32_t linger = 0;  // ticks for which refinement stays after the contact has ended
};

/// Bisection of one edge by local refinement, or the undoing of a bisection.
struct RefinementStep {
  SplitEdge split;
  bool made = true;  // false: undone
  /// Masses in kg, set only if the bisection was undone: of the removed node before it was undone, and of the
  /// edge's ends a and b afterwards.
  double node_mass = 0, a_mass = 0, b_mass = 0;
};

/// Edge bisected by local refinement, as stored in checkpoints: its end nodes, and the ticks until the
/// bisection may be undone.
struct RefinedEdge {
  NodeId a = 0, b = 0;
  std::uint32_t left = 0;  // ticks until the bisection may be undone
  bool operator==(const RefinedEdge&) const = default;
};

class LocalRefinement {
 public:
  /// Starts with the unrefined compiled mesh `rest`. `density` in kg/m³. `limits`: element size and reach of
  /// the refinement, most added tetrahedra, and linger time. Throws InputError for an invalid mesh, as
  /// TetComplex does.
  LocalRefinement(const TetMesh& rest, double density, const RefinementLimits& limits);

  const TetComplex& complex() const { return complex_; }
  const RefinementLimits& limits() const { return limits_; }
  bool any() const { return !splits_.empty(); }
  /// Returns by how many tetrahedra the refined mesh exceeds the compiled mesh.
  std::size_t added() const { return complex_.tets() - compiled_tets_; }

  /// Advances by one tick: bisects edges near touched places, and undoes bisections where the contact ended
  /// long enough ago. `resting`: whether the body sleeps and its contacts do not change, so nothing is
  /// undone. `settle`: whether bisections may be undone in this tick. Returns the steps in the order in which
  /// they were applied.
  std::vector<RefinementStep> follow(const TouchedPlaces& touched, bool resting, bool settle);
  /// Undoes all bisections whose halves are not split further, however long ago the contact was. Returns the
  /// steps in order.
  std::vector<RefinementStep> take_back();

  /// Returns a LocalRefinement without any bisection, with the same density and limits. `rest`: the compiled
  /// mesh from which this object was built.
  LocalRefinement unrefined(const TetMesh& rest) const { return {rest, complex_.density(), limits_}; }
  /// Returns whether ids are so sparse that compacted() is worthwhile. They are if more than four times as
  /// many tetrahedron ids were used as the mesh can have tetrahedra: its present number plus
  /// RefinementLimits::most.
  bool is_sparse() const;
  /// Returns an equal refinement without unused ids: with the ids that bisect(edges()) assigns to the
  /// compiled mesh `rest`. The order of ids is kept, so that later steps are equal, too.
  LocalRefinement compacted(const TetMesh& rest) const;

  /// Returns the bisected edges in the order of bisection, for a checkpoint. Nodes are numbered as if
  /// bisections that were undone had never been made.
  std::vector<RefinedEdge> edges() const;
  /// Bisects these edges, in order, of the unrefined compiled mesh, to restore a checkpoint. Throws
  /// InputError for an edge that does not exist, and if the limits on added tetrahedra or linger time are
  /// exceeded.
  void bisect(std::span<const RefinedEdge> edges);

 private:
  struct Split {
    SplitEdge op;
    std::uint32_t left = 0;  // ticks until the bisection may be undone
  };
  struct Wanted {
    double distance = 0;  // m
    TetId tet = 0;
  };
  /// Edge of a tetrahedron, for comparison by squared length. Of two equally long edges, the one with lower
  /// node ids counts as longer.
  struct RankedEdge {
    double squared = -1;  // m²; negative: not computed yet
    NodeId a = 0, b = 0;  // a < b
    bool operator<(const RankedEdge& o) const {
      return squared != o.squared ? squared < o.squared : std::tie(o.a, o.b) < std::tie(a, b);
    }
  };
  struct RestBox {
    Vec3 low, high;  // m
  };
  bool is_touched(const TouchedPlaces& touched, const Split& split) const;
  void keep_touched(const TouchedPlaces& touched, bool resting);
  RestBox box_of(TetId tet) const;
  const RankedEdge& longest_edge(TetId tet);
  std::vector<Wanted> too_large(const TouchedPlaces& touched);
  void refine(const TouchedPlaces& touched, std::vector<RefinementStep>& steps);
  bool may_add(std::size_t tets, std::size_t at_begin) const;
  bool split_longest_beside(TetId tet, std::size_t at_begin, std::vector<RefinementStep>& steps);
  void split(NodeId a, NodeId b, std::vector<RefinementStep>& steps);
  void coarsen(std::uint32_t left, std::vector<RefinementStep>& steps);
  bool can_take_back(const SplitEdge& op) const;

  RefinementLimits limits_;
  TetComplex complex_;
  std::size_t compiled_nodes_, compiled_tets_;
  std::vector<Split> splits_;          // bisections in force, in the order in which they were made
  std::vector<RankedEdge> longest_;    // by tetrahedron, computed when needed
  mutable std::vector<TetId> around_;  // scratch
};

}  // namespace prosector::cutting
