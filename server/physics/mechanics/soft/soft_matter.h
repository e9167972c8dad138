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

namespace prosector {

/// Additional data of a body of quadratic elements.
struct QuadraticNodes {
  EdgeNodes edges;
  SparseMap embedding;  // of the surface, in the vertices only
  TetMesh eighths;      // linear tetrahedra on the same nodes, eight per quadratic one
};

struct SoftMatter {
  /// Initialises the data as described at SoftBody's constructor.
  SoftMatter(const SoftDesc& desc, Anatomy anatomy);

  SoftDesc desc;
  std::optional<QuadraticNodes> quadratic;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  BlockPattern pattern;
  SymmetricPattern symmetric;
  VecX mass, ties;  // n, kg; n, N/m, as described in the scene
  /// n: ratio of a node's weight by shape functions to its weight by mass; empty: linear elements, all 1.
  VecX borne;
  // A material that is s times as stiff moves as if inertia, attachments and loads were divided by s. The
  // equations are solved in that form and results are multiplied by s, so elements need not know s.
  double strength = 1;  // s
  bool tied = true;
  VecX inertia, attached;    // n, kg; n, N/m: mass and ties divided by s
  std::vector<double> area;  // m², per surface vertex, in the rest shape
  double diagonal;           // m, of the rest shape's bounding box

  /// Computes inertia and attached from mass, ties, strength and tied.
  void weigh();
  /// Recomputes all but the surface areas from model and pattern, which followed a cut.
  void fit();

  std::size_t node_count() const { return model->connectivity().nodes(); }
  std::size_t vertex_count() const { return quadratic ? quadratic->edges.vertices() : node_count(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return quadratic ? quadratic->eighths : anatomy.tets; }
  /// Returns whether gravity acts, see SoftBody::weight().
  bool falls() const;
};

}  // namespace prosector
