#pragma once
// Factories of the implicit integrators in integrators(); one file per family.

#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector {

/// Creates implicit Euler: first order, L-stable; damps oscillations of angular frequency ω with a damping
/// ratio of about ωh/2.
std::unique_ptr<TimeIntegrator> make_implicit_euler();

/// Creates BDF2: second order, L-stable; the first step after a restart is implicit Euler.
std::unique_ptr<TimeIntegrator> make_bdf2();

/// Creates TR-BDF2: second order, L-stable, two stages; an oscillation with ωh = ½ loses 0.02 % per step. The
/// first stage after a restart is implicit Euler.
std::unique_ptr<TimeIntegrator> make_tr_bdf2();

/// Computes y = x_v + c·v_h + c²·g from x_v, with v_h passed in stage.y.
void finish_inertia_target(double c, const Weight& weight, Stage& stage);
/// Stores x and v = (x − x_v)/c in the motion; its previous state becomes its history.
void advance(const Stage& stage, const Eigen::Ref<const VecX>& x, Motion& motion);

}  // namespace prosector
