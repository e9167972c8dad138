#pragma once
// Steps one soft body with its implicit integrator, stage by stage. Between the calls, the caller finds each
// stage's minimum (incremental_potential.h), together with the neighbouring bodies.

#include <memory>

#include "server/physics/mechanics/soft/incremental_potential.h"
#include "server/physics/mechanics/soft/integrators/soft_state.h"
#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector::soft {

class ImplicitStepper {
 public:
  /// Initialises the stepper with the integrator that the scene names. `substepped`: the body normally
  /// advances by explicit or position-based substeps. Implicit Euler is then used instead, for its
  /// equilibrium and for steps in which its own method fails. `matter` and `potential` must outlive this
  /// object. Throws InputError for an unknown integrator.
  ImplicitStepper(const SoftMatter& matter, IncrementalPotential& potential, bool substepped);

  /// Returns the body's implicit integrator, of which each stage is one minimisation of the incremental
  /// potential.
  const TimeIntegrator& integrator() const { return *integrator_; }

  // ---- One step
  /// Begins a stage (one minimisation) of a step of h s: sets up the body's incremental potential for it.
  /// `weight`: gravity on the nodes. `euler`: uses implicit Euler instead of integrator(); must be the same
  /// for all stages of a step.
  void begin_stage(int stage_index, double h, const Weight& weight, const SoftBodyState& state,
                   bool euler = false);
  const Stage& stage() const { return potential_.stage(); }
  /// Computes the initial guess of node positions x (3n, m) for Newton's method in the current stage. For
  /// integrators with one stage it is x_n + h·v_n + warm_start, which assumes constant acceleration. For
  /// others it assumes constant velocity.
  void initial_guess(double h, const SoftBodyState& state, Eigen::Ref<VecX> x) const;
  /// Stores the node positions x (3n, m) that minimise the stage's potential in the body's state, with
  /// velocities, viscoelastic stress and warm start.
  void finish_stage(int stage_index, double h, const Eigen::Ref<const VecX>& x, SoftBodyState& state) const;
  /// Sets whether the following steps treat viscoelastic stress relaxation as complete, as in a body held for
  /// an infinite time. Used to find the body's equilibrium.
  void set_relaxed(bool relaxed) { relaxed_ = relaxed; }

  // ---- Restoring a step's start
  /// Saves the node positions, velocities and viscoelastic stress history of `state`, so that recall() can
  /// restore them and the step can be repeated.
  void remember(const SoftBodyState& state);
  /// Restores the positions, velocities and stress history saved by remember(). Clears the data of the
  /// previous step, so multi-step integrators restart.
  void recall(SoftBodyState& state) const;
  const Motion& remembered() const { return remembered_; }  // x and v

  /// Discards all data of past steps and resizes arrays to the body's present number of nodes. Called after
  /// the body's mesh was changed by a cut.
  void reset();

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

}  // namespace prosector::soft
