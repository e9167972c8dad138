#pragma once
// Takes one soft body through a step of its implicit integrator, stage by stage. Who calls this finds each
// stage's minimum in between (incremental_potential.h), together with the bodies around it.

#include <memory>

#include "server/physics/soft/incremental_potential.h"
#include "server/physics/soft/integrators/soft_state.h"
#include "server/physics/soft/integrators/time_integrator.h"

namespace prosector {

class ImplicitStepper {
 public:
  /// Makes the stepper; both must outlive this. `substepped`: whether the body has a substepper: implicit
  /// Euler, then, finds its equilibrium and steps it where its own method fails. Throws InputError for an
  /// unknown integrator.
  ImplicitStepper(const SoftMatter& matter, IncrementalPotential& potential, bool substepped);

  /// Returns the integrator with which the body is minimised.
  const TimeIntegrator& integrator() const { return *integrator_; }

  // ---- One step
  /// Starts a stage of a step of h s: finds what the potential is to be. `euler`: by implicit
  /// Euler, whatever integrator() is; the same for all stages of the step.
  void begin_stage(int stage_index, double h, const Weight& weight, const SoftBodyState& state,
                   bool euler = false);
  const Stage& stage() const { return potential_.stage(); }
  /// Finds where Newton may start in the stage begun, 3n, m. That is x_n + h·v_n + warm_start, to which
  /// constant acceleration would lead; of a method of several stages, to which constant velocity would.
  void initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const;
  /// Takes the stage's minimiser into the state.
  void finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x, SoftBodyState& state) const;
  /// Has steps be those of a body that has been held for ever, whatever its relaxation, while `relaxed`: for
  /// finding its equilibrium.
  void set_relaxed(bool relaxed) { relaxed_ = relaxed; }

  // ---- Going back to a step's start
  /// Keeps positions, velocities and history of stress.
  void remember(const SoftBodyState& state);
  /// Puts them back; nothing is known of the step before.
  void recall(SoftBodyState& state) const;
  const Motion& remembered() const { return remembered_; }  // x and v

  /// Forgets all steps: the body followed a cut.
  void start_anew();

 private:
  const SoftMatter& matter_;
  IncrementalPotential& potential_;
  std::unique_ptr<TimeIntegrator> euler_, integrator_;
  const TimeIntegrator* stepping_ = nullptr;  // the one of the step begun
  VecX x_n_;                                  // 3n, m: the step's start
  bool relaxed_ = false;
  Motion remembered_;  // x, v
  VecX history_;       // with them
};

}  // namespace prosector
