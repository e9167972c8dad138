#pragma once
// State of one soft body: all data that affect the next tick's result.

#include "server/physics/mechanics/soft/integrators/time_integrator.h"

namespace prosector {

struct SoftBodyState {
  Motion motion;
  VecX warm_start;  // 3n, m: velocity change of the last step times h, see ImplicitStepper::initial_guess()
  VecX history;     // viscoelastic stress, see relaxation.h; empty: none
  bool asleep = true;
  int quiet_ticks = 0;
  int tangled_ticks = 0;  // consecutive ticks with inverted elements and no external cause of the inversion
  int steps_down = 0;     // number of accuracy reductions, see effort.h
  /// Whether the body is stepped under the law of SoftBody::recovery(), see coupled/recovery.h.
  bool recovering = false;
  double law_seconds = 0;   // s: time for which the criterion to switch the law has been met
  double energy_slack = 0;  // J: excess of recent energy over present energy, see energy_guard.h
  // Integrators in substeps only; otherwise empty and 0.
  VecX mode;  // 3n, unit: approximate shape of the body's fastest oscillation
  /// Explicit: approximate angular frequency of `mode`, 1/s. Position-based: substeps per second that were
  /// needed recently; 0: as described in the scene.
  double omega = 0;
};

}  // namespace prosector
