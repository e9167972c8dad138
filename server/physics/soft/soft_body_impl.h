#pragma once
// What a SoftBody consists of.

#include <optional>
#include <vector>

#include "server/physics/soft/base/node_sum.h"
#include "server/physics/soft/body_hessian.h"
#include "server/physics/soft/elements/edge_nodes.h"
#include "server/physics/soft/integrators/substepper.h"
#include "server/physics/soft/integrators/time_integrator.h"
#include "server/physics/soft/soft_body.h"
#include "server/physics/soft/stiffness_damping.h"

namespace prosector {

/// What a body of quadratic elements has besides.
struct QuadraticNodes {
  EdgeNodes edges;
  SparseMap embedding;  // of the surface, in the vertices alone
  TetMesh eighths;      // of the tetrahedra: linear ones on the same nodes
};

struct SoftBody::Impl {
  SoftDesc desc;
  std::optional<QuadraticNodes> quadratic;
  Anatomy anatomy;
  std::unique_ptr<ElasticModel> model;
  std::unique_ptr<TimeIntegrator> integrator, euler;
  const TimeIntegrator* stepping = nullptr;  // the one of the step begun
  BlockPattern pattern;
  SymmetricPattern symmetric;
  VecX mass, ties;  // n kg; n N/m, as described
  // A material that is s times as stiff moves as if inertia, ties and loads were 1/s of what they are: so it
  // is computed, and what leaves this class is multiplied by s. No element knows of it.
  double strength = 1;  // s
  bool tied = true;
  VecX inertia, attached;  // n kg; n N/m: those divided by s
  std::unique_ptr<Substepper> substepper;
  std::unique_ptr<SoftBody> recovery;
  bool keeps_recovering = false;
  std::vector<double> area;
  double diagonal;    // m
  Motion remembered;  // x, v
  VecX history;       // with them

  Stage stage;
  VecX x_n;              // 3n
  bool relaxed = false;  // see set_relaxed
  SoftSystem system;
  StageElements elements;
  StiffnessDamping damping;
  std::optional<BodyHessian> hessian;
  NodeSum node_sum;

  Impl(const SoftDesc& desc, Anatomy anatomy);
  /// Nothing is known of any step.
  void start_anew();
  void weigh();
  void build_on_inertia();
  /// To model and pattern as they are after a cut; the surface's area is the caller's.
  void fit();
  void follow(const MeshEdit& edit);

  std::size_t node_count() const { return model->connectivity().nodes(); }
  std::size_t vertex_count() const { return quadratic ? quadratic->edges.vertices() : node_count(); }
  const VecX& rest() const { return model->rest(); }
  const TetMesh& linear_tets() const { return quadratic ? quadratic->eighths : anatomy.tets; }

  void scale(double factor, double* vector) const {
    if (factor != 1) Eigen::Map<VecX>(vector, rest().size()) *= factor;
  }

  StageWeights weights() const {
    return {stage.alpha + desc.damping_mass / stage.dxdv, desc.damping_stiffness / stage.dxdv};
  }
};

}  // namespace prosector
