#pragma once
// What a soft body is made of: its description, mesh, elements and masses. Plain data that the body's parts
// share: the potential, the steppers, and what follows cuts.

#include <memory>
#include <optional>
#include <vector>

#include "common/mesh.h"
#include "common/scene/scene.h"
#include "server/physics/soft/elements/edge_nodes.h"
#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/matrices/block_matrix.h"
#include "server/physics/soft/matrices/symmetric_rows.h"

namespace prosector {

/// What a body of quadratic elements has besides.
struct QuadraticNodes {
  EdgeNodes edges;
  SparseMap embedding;  // of the surface, in the vertices alone
  TetMesh eighths;      // linear tetrahedra on the same nodes, eight for each quadratic one
};

struct SoftMatter {
  /// Makes it as SoftBody's constructor says.
  SoftMatter(const SoftDesc& desc, Anatomy anatomy);

  SoftDesc desc;
  std::optional<QuadraticNodes> quadratic;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  BlockPattern pattern;
  SymmetricPattern symmetric;
  VecX mass, ties;  // n kg; n N/m, as described
  VecX borne;       // n: by shape functions, of a node's weight by its mass; empty: linear elements, all 1
  // A material that is s times as stiff moves as if inertia, ties and loads were 1/s of what they are. So it
  // is computed, and what leaves the body is multiplied by s: no element knows of it.
  double strength = 1;  // s
  bool tied = true;
  VecX inertia, attached;    // n kg; n N/m: those divided by s
  std::vector<double> area;  // m², of each surface vertex at rest
  double diagonal;           // m, of the rest shape's bounding box

  /// Finds inertia and attached from mass, ties, strength and tied.
  void weigh();
  /// Finds everything but the surface's area anew from model and pattern, which followed a cut.
  void fit();

  std::size_t node_count() const { return model->connectivity().nodes(); }
  std::size_t vertex_count() const { return quadratic ? quadratic->edges.vertices() : node_count(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return quadratic ? quadratic->eighths : anatomy.tets; }
  /// Tells whether gravity acts, see SoftBody::weight().
  bool falls() const;
};

}  // namespace prosector
