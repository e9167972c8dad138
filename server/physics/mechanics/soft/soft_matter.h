#pragma once
// Description, mesh, elements and masses of a soft body, as plain data. The body's parts share them: the
// potential, the steppers and the mesh follower.

#include <memory>
#include <optional>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/elements/edge_nodes.h"
#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/matrices/symmetric_rows.h"

namespace prosector::soft {

/// Additional data of a soft body with quadratic tetrahedra: its edge nodes, the surface's embedding in
/// vertices only, and the mesh of linear tetrahedra on the same nodes.
struct QuadraticNodes {
  EdgeNodes edges;
  SparseMap embedding;  // of the surface, in the vertices only
  TetMesh eighths;      // linear tetrahedra on the same nodes, eight per quadratic one
};

struct SoftMatter {
  /// Creates mesh, elements, masses and attachments of a soft body from its scene description and its mesh in
  /// the world frame. Throws InputError for invalid descriptions or meshes.
  SoftMatter(const SoftDesc& desc, Anatomy anatomy);

  SoftDesc desc;
  std::optional<QuadraticNodes> quadratic;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  BlockPattern pattern;
  SymmetricPattern symmetric;
  VecX mass, ties;  // n, kg; n, N/m, as described in the scene
  /// Ratio of each node's weight by shape functions to its weight by mass (n), for bodies that something
  /// supports. Empty for linear elements, whose ratios are all 1.
  VecX borne;
  // A material that is s times as stiff moves as if inertia, attachments and loads were divided by s. The
  // equations are solved in that form and results are multiplied by s, so elements need not know s.
  double strength = 1;  // s
  bool tied = true;
  VecX inertia, attached;    // n, kg; n, N/m: mass and ties divided by s
  std::vector<double> area;  // m², per surface vertex, in the rest shape
  double diagonal;           // m, of the rest shape's bounding box

  /// Computes `inertia` and `attached`, the masses and attachment stiffnesses divided by the stiffness factor
  /// `strength`. `attached` is zero if the attachments are disabled.
  void weigh();
  /// Recomputes masses, attachments and the bounding diagonal after `model` and `pattern` were updated for a
  /// cut. Surface areas are updated elsewhere.
  void fit();

  std::size_t node_count() const { return model->connectivity().nodes(); }
  std::size_t vertex_count() const { return quadratic ? quadratic->edges.vertices() : node_count(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return quadratic ? quadratic->eighths : anatomy.tets; }
  /// Returns whether gravity acts on the body. It does not while a body that was imaged under its own weight
  /// (`gravity = false`) is held by its attachments, see SoftBody::weight().
  bool falls() const;
};

}  // namespace prosector::soft
