#pragma once
// What a soft body's equations are made of, and how a stage of a step weighs it.

#include "common/scene/scene.h"
#include "server/physics/soft/elements/elastic_model.h"
#include "server/physics/soft/matrices/block_matrix.h"
#include "server/physics/soft/matrices/symmetric_rows.h"

namespace prosector {

/// Const while running, but what the model keeps of the last positions.
struct SoftSystem {
  const SoftDesc& desc;
  ElasticModel& model;
  const BlockPattern& pattern;
  const SymmetricPattern& symmetric;
  const VecX& mass;      // n, kg
  const VecX& attached;  // n, N/m

  bool damped() const { return desc.damping_stiffness > 0; }
};

/// The Hessian of a stage is H = inertia·M + scale()·(K + attachments).
struct StageWeights {
  double inertia = 0;        // 1/s²: the integrator's α, and damping proportional to mass
  double damping_share = 0;  // of stiffness, by damping proportional to it
  double scale() const { return 1 + damping_share; }
};

}  // namespace prosector
