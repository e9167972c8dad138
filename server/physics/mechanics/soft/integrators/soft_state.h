#pragma once
// State of one soft body: all data that affect the next tick's result.

#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector::soft {

struct SoftBodyState {
  Motion motion;
  VecX warm_start;  // 3n, m: velocity change of the last step times h, see ImplicitStepper::initial_guess()
  VecX history;     // viscoelastic stress, see relaxation.h; empty: none
  bool asleep = true;
  int quiet_ticks = 0;
  int tangled_ticks = 0;  // consecutive ticks with inverted elements and no external cause of the inversion
  int steps_down = 0;     // number of accuracy reductions, see effort.h
  /// Whether the soft body is stepped under its recovery law instead of the material law in its description.
  /// The recovery law is a corotational material that leads out of inverted shapes (coupled/recovery.h).
  bool recovering = false;
  double law_seconds = 0;   // s: time for which the criterion to switch the law has been met
  double energy_slack = 0;  // J: excess of recent energy over present energy, see energy_guard.h
  // Integrators in substeps only; otherwise empty and 0.
  VecX mode;  // 3n, unit: approximate shape of the body's fastest oscillation
  /// For explicit integrators, the approximate angular frequency of `mode`, the body's fastest oscillation,
  /// 1/s. For position-based dynamics, the substeps per second that were needed recently; 0 means as many as
  /// the scene describes.
  double omega = 0;
};

}  // namespace prosector::soft
