#pragma once
// Factories of the implicit integrators in integrators(); one file per family.

#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector::soft {

/// Creates the implicit Euler integrator: first order and L-stable. It damps an oscillation of angular
/// frequency ω with a damping ratio of about ωh/2, where h is the time step.
std::unique_ptr<TimeIntegrator> make_implicit_euler();

/// Creates the BDF2 integrator (backward differentiation formula): second order and L-stable. The first step
/// after a restart uses implicit Euler.
std::unique_ptr<TimeIntegrator> make_bdf2();

/// Creates the TR-BDF2 integrator: second order and L-stable, with two stages per step. An oscillation with
/// ωh = ½ loses 0.02 % of its amplitude per step (ω: angular frequency, h: time step). The first stage after
/// a restart uses implicit Euler.
std::unique_ptr<TimeIntegrator> make_tr_bdf2();

/// Completes a stage's data: y = x_v + c·v_h + c²·g, the node positions under inertia and gravity alone, and
/// α = 1/c². On entry stage.y must hold the velocities v_h (3n, m/s), and stage.x_v the positions x_v.
void finish_inertia_target(double c, const Weight& weight, Stage& stage);
/// Stores the node positions x (3n, m) and the velocities v = (x − x_v)/c in `motion`, where c is
/// `stage.dxdv`. The values that `motion` had before become its previous step.
void advance(const Stage& stage, const Eigen::Ref<const VecX>& x, Motion& motion);

}  // namespace prosector::soft
