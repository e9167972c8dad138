#pragma once
// A soft body whose tetrahedra are smaller where it is touched (cutting/local_refinement.h): its geometry,
// and what its nodes and tetrahedra have.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "server/physics/cutting/local_refinement.h"
#include "server/physics/organs/node_transfer.h"
#include "server/physics/soft/soft_body.h"

namespace prosector {

struct RefinedBody {
  /// Takes a body as compiled, whose description says how it is refined. `tick_rate`: Hz. Throws InputError
  /// for what has no linear tetrahedra, or flat ones.
  RefinedBody(const SoftBody& compiled, double tick_rate);
  /// Takes tetrahedra that are no body's yet. `density`: kg/m³. Throws InputError for what TetComplex
  /// refuses.
  RefinedBody(Anatomy anatomy, double density, const RefinementLimits& limits);

  Anatomy whole;                   // as compiled
  std::uint64_t content_hash = 0;  // of the body as compiled
  std::vector<TetId> carrier;      // by surface vertex: the compiled tetrahedron that it hangs on
  PieceMesh piece;                 // as the body's solver has it
  std::uint64_t rehung = 0;        // how often its surface came to hang on other nodes

  // ---- State
  LocalRefinement mesh;
  bool touched = false;  // in the last tick in which it was awake; of one that is refined
};

/// Returns the tetrahedra as they are. Nodes and tetrahedra of the compiled mesh keep their indices.
PieceMesh refined_mesh(const RefinedBody& body);
/// Returns what the surface hangs on: for each vertex the tetrahedron of those now that has its place, with
/// weights up to max_embedding_weight or what they were.
SparseMap refined_embedding(const RefinedBody& body, const PieceMesh& now);
Anatomy refined_anatomy(const RefinedBody& body, const PieceMesh& now);

/// Returns a field that is linear between the compiled mesh's nodes, where it is `compiled` (3 numbers each).
VecX refined_field(const RefinedBody& body, const PieceMesh& now, const VecX& compiled);

/// What becomes of a field where nodes go.
enum class Leaving : std::uint8_t {
  nothing,  // what stays keeps what it has
  momentum  // the ends of its edge get what a node had more of than they, by their masses
};
/// Takes a field (3 numbers of each node in `before`) through the steps; new nodes have what was there.
VecX carried(const VecX& field, const PieceMesh& before, const PieceMesh& now,
             std::span<const RefinementStep> steps, Leaving leaving);
/// Takes the viscoelastic history of tetrahedra through the steps. Halves have what the whole had, a whole
/// the mean of its halves.
VecX refined_history(const VecX& history, const TetComplex& complex, const PieceMesh& before,
                     const PieceMesh& now, std::span<const RefinementStep> steps);

/// By soft body: those whose descriptions ask for it.
using RefinedBodies = std::map<std::size_t, RefinedBody>;

}  // namespace prosector
