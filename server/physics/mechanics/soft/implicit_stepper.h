#pragma once
// Steps one soft body with its implicit integrator, stage by stage. Between the calls, the caller finds each
// stage's minimum (incremental_potential.h), together with the neighbouring bodies.

#include <memory>

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/soft_state.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector {

class ImplicitStepper {
 public:
  /// Takes the body's matter and potential, which must outlive this object. `substepped`: the body has a
  /// substepper. It then uses implicit Euler to find its equilibrium, and for steps in which its own method
  /// fails. Throws InputError for an unknown integrator.
  ImplicitStepper(const SoftMatter& matter, IncrementalPotential& potential, bool substepped);

  /// Returns the integrator whose stages are minimised.
  const TimeIntegrator& integrator() const { return *integrator_; }

  // ---- One step
  /// Begins a stage of a step of h s: sets up the potential. `euler`: uses implicit Euler instead of
  /// integrator(); must be the same for all stages of a step.
  void begin_stage(int stage_index, double h, const Weight& weight, const SoftBodyState& state,
                   bool euler = false);
  const Stage& stage() const { return potential_.stage(); }
  /// Computes Newton's initial guess for the current stage, 3n, m. That is x_n + h·v_n + warm_start, which
  /// assumes constant acceleration. Methods with several stages assume constant velocity.
  void initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const;
  /// Stores the stage's minimiser in the state.
  void finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x, SoftBodyState& state) const;
  /// Sets whether steps treat the body as held for an infinite time, with all stress relaxation complete.
  /// Used to find its equilibrium.
  void set_relaxed(bool relaxed) { relaxed_ = relaxed; }

  // ---- Restoring a step's start
  /// Saves positions, velocities and stress history.
  void remember(const SoftBodyState& state);
  /// Restores the saved values; the step before is treated as unknown.
  void recall(SoftBodyState& state) const;
  const Motion& remembered() const { return remembered_; }  // x and v

  /// Discards all past steps after the body followed a cut.
  void start_anew();

 private:
  const SoftMatter& matter_;
  IncrementalPotential& potential_;
  std::unique_ptr<TimeIntegrator> euler_, integrator_;
  const TimeIntegrator* stepping_ = nullptr;  // integrator of the current step
  VecX x_n_;                                  // 3n, m: positions at the step's start
  bool relaxed_ = false;
  Motion remembered_;  // x, v
  VecX history_;       // saved with them
};

}  // namespace prosector
