#pragma once
// A soft body with local refinement near contacts (cutting/local_refinement.h): geometry, and transfer of
// fields of its nodes and tetrahedra.

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "server/physics/mechanics/cutting/local_refinement.h"
#include "server/physics/mechanics/organs/node_transfer.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {

/// A body with local refinement.
struct RefinedBody {
  /// Initialises from a compiled body, whose description sets the refinement. `tick_rate`: Hz. Throws
  /// InputError for a body without linear tetrahedra, or with flat ones.
  RefinedBody(const SoftBody& compiled, double tick_rate);
  /// Initialises from tetrahedra without a body. `density`: kg/m³. Throws InputError for meshes that
  /// TetComplex refuses.
  RefinedBody(Anatomy anatomy, double density, const RefinementLimits& limits);

  Anatomy whole;                   // as compiled
  std::uint64_t content_hash = 0;  // of the body as compiled
  std::vector<TetId> carrier;      // by surface vertex: the compiled tetrahedron in which it is embedded
  PieceMesh piece;                 // in the state of the body's solver
  std::uint64_t rehung = 0;        // number of times its surface was re-embedded

  // ---- State
  LocalRefinement mesh;
  bool touched = false;  // of a refined body: touched in the last tick in which it was awake
};

/// Returns the current tetrahedra. Nodes and tetrahedra of the compiled mesh keep their indices.
PieceMesh refined_mesh(const RefinedBody& body);
/// Returns the surface's embedding. Each vertex is embedded in the current tetrahedron at its position.
/// Weights are at most max_embedding_weight, or as large as before.
SparseMap refined_embedding(const RefinedBody& body, const PieceMesh& now);
Anatomy refined_anatomy(const RefinedBody& body, const PieceMesh& now);

/// Returns a field that interpolates `compiled` (3 numbers per node of the compiled mesh) linearly.
VecX refined_field(const RefinedBody& body, const PieceMesh& now, const VecX& compiled);

/// Treatment of a field where nodes are removed.
enum class Leaving : std::uint8_t {
  nothing,  // remaining nodes keep their values
  momentum  // the excess of a removed node is distributed to the ends of its edge, by their masses
};
/// Applies refinement steps to a field (3 numbers of each node in `before`). New nodes get interpolated
/// values.
VecX carried(const VecX& field, const PieceMesh& before, const PieceMesh& now,
             std::span<const RefinementStep> steps, Leaving leaving);
/// Applies refinement steps to the viscoelastic history of tetrahedra. Halves get the values of the whole; a
/// whole gets the mean of its halves.
VecX refined_history(const VecX& history, const TetComplex& complex, const PieceMesh& before,
                     const PieceMesh& now, std::span<const RefinementStep> steps);

/// By soft body: bodies whose descriptions enable refinement.
using RefinedBodies = std::map<std::size_t, RefinedBody>;

}  // namespace prosector
