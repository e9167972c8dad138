#pragma once
// Data of a soft body's equations of motion, and their weights in a stage of a step.

#include "common/scene/scene.h"
#include "server/physics/mechanics/soft/elements/elastic_model.h"
#include "server/physics/mechanics/soft/matrices/block_matrix.h"
#include "server/physics/mechanics/soft/matrices/symmetric_rows.h"

namespace prosector::soft {

/// References to the data of a soft body's equations of motion: description, elastic model, matrix patterns,
/// nodal masses and attachment stiffnesses. They are constant during a session, except after cuts and for the
/// model's cache of the last positions.
struct SoftSystem {
  const SoftDesc& desc;
  ElasticModel& model;
  const BlockPattern& pattern;
  const SymmetricPattern& symmetric;
  const VecX& mass;      // n, kg
  const VecX& attached;  // n, N/m

  bool damped() const { return desc.material.damping_stiffness > 0; }
};

/// Factors of the matrices in a stage's Hessian H = inertia·M + scale()·(K + attachments), where M is the
/// mass matrix, K the elements' stiffness, and scale() includes stiffness-proportional damping.
struct StageWeights {
  double inertia = 0;        // 1/s²: the integrator's α plus mass-proportional damping
  double damping_share = 0;  // stiffness-proportional damping, as a fraction of the stiffness
  double scale() const { return 1 + damping_share; }
};

}  // namespace prosector::soft
