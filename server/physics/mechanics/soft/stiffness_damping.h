#pragma once
// Stiffness-proportional damping: the potential ½dᵀKd of the displacement d = x − x_v, with K at the stage's
// first evaluation point (see stage_elements.h). IncrementalPotential adds this potential times
// damping_stiffness / dxdv.

#include "server/physics/mechanics/soft/base/node_sum.h"
#include "server/physics/mechanics/soft/stage_elements.h"

namespace prosector {

class StiffnessDamping {
 public:
  /// Takes the system and its elements; both must outlive this object.
  StiffnessDamping(const SoftSystem& system, StageElements& elements);
  /// Allocates for the given number of nodes and discards cached data.
  void fit(std::size_t nodes);

  /// Begins a stage. `x_v`: 3n, m, must outlive the stage.
  void begin_stage(const VecX& x_v);
  /// Computes energy() at x, and forces() only if requested. Does nothing if they are known at x.
  void update(const Eigen::Ref<const VecX>& x, bool forces);
  double energy() const { return energy_; }       // ½dᵀKd
  const VecX& forces() const { return forces_; }  // 3n: K·d

 private:
  const BlockPattern& pattern_;
  StageElements& elements_;
  NodeSum sum_;
  const VecX* x_v_ = nullptr;
  VecX drift_, forces_;
  double energy_ = 0;
  bool known_ = false, forces_known_ = false;
};

}  // namespace prosector
