#pragma once
// The integrators behind the rows of integrators(); one file per family.

#include "server/physics/soft/integrators/time_integrator.h"

namespace prosector {

/// Makes implicit Euler: first order, L-stable; it damps oscillations of angular frequency ω by a ratio of
/// about ωh/2.
std::unique_ptr<TimeIntegrator> make_implicit_euler();

/// Makes BDF2: second order, L-stable; its first step after a restart is implicit Euler's.
std::unique_ptr<TimeIntegrator> make_bdf2();

/// Makes TR-BDF2: second order, L-stable, two stages; of an oscillation with ωh = ½ it loses 0.02 % a step.
/// Its first stage after a restart is implicit Euler's.
std::unique_ptr<TimeIntegrator> make_tr_bdf2();

/// Computes y = x_v + c·v_h + c²·g, from x_v and with v_h given in stage.y.
void finish_inertia_target(double c, const Weight& weight, Stage& stage);
/// Moves v = (x − x_v)/c and x into the motion, whose present state becomes its history.
void advance(const Stage& stage, const Eigen::Ref<const VecX>& x, Motion& motion);

}  // namespace prosector
