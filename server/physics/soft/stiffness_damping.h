#pragma once
// Damping proportional to stiffness: the potential ½dᵀKd of how far a stage has led, d = x − x_v, K as it is
// at the stage's first place (see stage_elements.h). Over dxdv and times the scene's damping_stiffness it is
// what IncrementalPotential adds.

#include "server/physics/soft/base/node_sum.h"
#include "server/physics/soft/stage_elements.h"

namespace prosector {

class StiffnessDamping {
 public:
  /// Takes the system and its elements; both must outlive this.
  StiffnessDamping(const SoftSystem& system, StageElements& elements);
  /// Makes room for so many nodes; nothing is known.
  void fit(std::size_t nodes);

  /// Begins a stage. `x_v`: 3n, m, must outlive it.
  void begin_stage(const VecX& x_v);
  /// Finds what is asked below, at x; forces() only if they are wanted. Does nothing where it is known.
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
