#pragma once
// Stiffness-proportional damping: the potential ½dᵀKd of the displacement d = x − x_v, with K at the stage's
// first evaluation point (see stage_elements.h). IncrementalPotential adds this potential times
// damping_stiffness / dxdv.

#include "server/physics/mechanics/soft/base/node_sum.h"
#include "server/physics/mechanics/soft/stage_elements.h"

namespace prosector::soft {

class StiffnessDamping {
 public:
  /// Initialises the damping potential of a soft body. `system` and `elements`, its equations and its
  /// elements, must outlive this object.
  StiffnessDamping(const SoftSystem& system, StageElements& elements);
  /// Resizes the arrays to the given number of nodes and discards cached energies and forces.
  void fit(std::size_t nodes);

  /// Begins a stage (one minimisation of an implicit step). `x_v`: node positions (3n, m) from which damping
  /// measures displacements; must outlive the stage.
  void begin_stage(const VecX& x_v);
  /// Computes energy() at node positions x (3n, m), and also forces() if `forces` is true. Does nothing if
  /// they are already known at x.
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

}  // namespace prosector::soft
