#pragma once
// Smaller tetrahedra where a body is touched, and back again where it isn't any more (docs/decisions/0025).
//
// Edges are bisected as a cut bisects them, so the mesh conforms, its rest shape, volume and mass stay.
// Which edge is the question of shapes: only one that is the longest of all tetrahedra around it is bisected.
// Where a longer one is in the way, that one is first (Rivara 1997, "New longest-edge algorithms for the
// refinement and/or improvement of unstructured triangulations"; ties: lower ids). What was bisected is taken
// back where its halves are whole, so in the end the mesh is what it was.

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

#include "common/byte_stream.h"
#include "common/mesh.h"
#include "server/physics/cutting/tet_complex.h"
#include "server/physics/cutting/touched_places.h"

namespace prosector {

struct RefinementLimits {
  double edge = 0;           // m: no longer one is left where it is touched
  double reach = 0;          // m: so far from what touches it
  std::size_t most = 0;      // tetrahedra at most that there are more than in the compiled mesh
  std::uint32_t linger = 0;  // ticks for which they stay after what touched it has left
};

/// One edge bisected, or its halves joined again.
struct RefinementStep {
  SplitEdge split;
  bool made = true;  // false: taken back
  /// Masses, kg: of the node that goes, as it was; of the ends, as they are then. Of one that is taken back.
  double node_mass = 0, a_mass = 0, b_mass = 0;
};

class LocalRefinement {
 public:
  /// Takes the compiled mesh, see TetComplex; density: kg/m³.
  LocalRefinement(const TetMesh& rest, double density, const RefinementLimits& limits);

  const TetComplex& complex() const { return complex_; }
  const RefinementLimits& limits() const { return limits_; }
  bool any() const { return !splits_.empty(); }
  /// Returns how many tetrahedra there are more than in the compiled mesh.
  std::size_t added() const { return complex_.tets() - compiled_tets_; }

  /// Goes on by a tick: makes smaller what is touched, takes back what hasn't been for long. `resting`: the
  /// body sleeps, touched as it was, so nothing is taken back. `settle`: whether what may go is looked for
  /// in this tick. Returns what was done, in order.
  std::vector<RefinementStep> follow(const TouchedPlaces& touched, bool resting, bool settle);
  /// Takes everything back.
  std::vector<RefinementStep> take_back();

  /// Returns one of that mesh, which is this one's, in which nothing is refined.
  LocalRefinement unrefined(const TetMesh& rest) const { return {rest, complex_.density(), limits_}; }
  /// Tells whether most ids are of what is gone.
  bool is_sparse() const;
  /// Returns the same with ids as load() would give. They keep their order, so it goes on alike.
  LocalRefinement compacted(const TetMesh& rest) const;

  void save(ByteWriter& out) const;
  /// Takes the compiled mesh through what was saved. Throws InputError for what doesn't fit.
  void load(ByteReader& in);

 private:
  struct Split {
    SplitEdge op;
    std::uint32_t left = 0;  // ticks until it may be taken back
  };
  struct Wanted {
    double distance = 0;  // m
    TetId tet = 0;
  };
  /// An edge, ordered by its length and, among equals, by its ends.
  struct RankedEdge {
    double squared = -1;  // m²; below 0: not found yet
    NodeId a = 0, b = 0;  // ascending
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
  std::vector<Split> splits_;          // in force, as they were made
  std::vector<RankedEdge> longest_;    // by tetrahedron, as far as they were asked for
  mutable std::vector<TetId> around_;  // scratch
};

}  // namespace prosector
