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

namespace prosector::organs {

/// Soft body whose tetrahedra are bisected near contacts and merged again later: the compiled mesh, the
/// current mesh, and for each surface vertex the compiled tetrahedron that carries it.
struct RefinedBody {
  /// Initialises from a compiled body, whose scene description sets the refined edge length, the reach and
  /// the number of elements. `tick_rate`: ticks per second, in Hz, which sets how many ticks refined elements
  /// outlast the contact. Throws InputError if the body does not consist of linear tetrahedra or if some of
  /// them are degenerate.
  RefinedBody(const soft::SoftBody& compiled, double tick_rate);
  /// Initialises from a mesh without a simulated body. `density`: kg/m³; `limits`: refined edge length,
  /// reach, and number of elements. Throws InputError for meshes that TetComplex refuses, such as those with
  /// tetrahedra without volume.
  RefinedBody(Anatomy anatomy, double density, const cutting::RefinementLimits& limits);

  Anatomy whole;                        // as compiled
  std::uint64_t content_hash = 0;       // of the body as compiled
  std::vector<cutting::TetId> carrier;  // by surface vertex: the compiled tetrahedron in which it is embedded
  PieceMesh piece;                      // in the state of the body's solver
  std::uint64_t rehung = 0;             // number of times its surface was re-embedded

  // ---- State
  cutting::LocalRefinement mesh;
  bool touched = false;  // of a refined body: touched in the last tick in which it was awake
};

/// Returns the current tetrahedra of a locally refined body. Nodes of the compiled mesh keep their indices,
/// and nodes on bisected edges follow. Each tetrahedron has its id in the refined mesh and its sort key.
PieceMesh refined_mesh(const RefinedBody& body);
/// Returns the embedding of a refined body's surface in the nodes of its current mesh `now`. Each vertex is
/// embedded in the current tetrahedron at its position, or in a larger ancestor if the weights would exceed
/// max_embedding_weight and their previous maximum.
SparseMap refined_embedding(const RefinedBody& body, const PieceMesh& now);
Anatomy refined_anatomy(const RefinedBody& body, const PieceMesh& now);

/// Returns a field on the current mesh `now` of a refined body, 3 values per node. It interpolates
/// `compiled`, a field with 3 values per node of the compiled mesh, linearly along bisected edges.
VecX refined_field(const RefinedBody& body, const PieceMesh& now, const VecX& compiled);

/// Treatment of a node field when merging refined tetrahedra removes nodes: the node's value is dropped, or
/// its momentum is passed on to the ends of its edge.
enum class Leaving : std::uint8_t {
  nothing,  // remaining nodes keep their values
  momentum  // the excess of a removed node is distributed to the ends of its edge, by their masses
};
/// Returns a field, 3 values per node, after refinement `steps` led from mesh `before` to mesh `now`. A new
/// node gets the value interpolated along its bisected edge. `leaving`: treatment of removed nodes, which
/// either drops the value or conserves momentum.
VecX carried(const VecX& field, const PieceMesh& before, const PieceMesh& now,
             std::span<const cutting::RefinementStep> steps, Leaving leaving);
/// Returns the viscoelastic history (values per tetrahedron) after refinement `steps` led from mesh `before`
/// to `now`. Both halves of a bisected tetrahedron get its values; a merged tetrahedron gets the mean of its
/// halves.
VecX refined_history(const VecX& history, const cutting::TetComplex& complex, const PieceMesh& before,
                     const PieceMesh& now, std::span<const cutting::RefinementStep> steps);

/// Soft bodies whose scene descriptions enable local refinement near contacts, by index of the soft body.
using RefinedBodies = std::map<std::size_t, RefinedBody>;

}  // namespace prosector::organs
