#pragma once
// State of one soft body: everything that changes the next tick's bits.

#include "server/physics/soft/integrators/time_integrator.h"

namespace prosector {

struct SoftBodyState {
  Motion motion;
  VecX warm_start;  // 3n, m: last step's change of velocity times h, see ImplicitStepper::initial_guess()
  VecX history;     // viscoelastic, see relaxation.h; empty: none
  bool asleep = true;
  int quiet_ticks = 0;
  int tangled_ticks = 0;  // in a row with inverted elements and nothing that holds them so
  int steps_down = 0;     // how far it is solved less exactly, see effort.h
  /// True while it is stepped under the law of SoftBody::recovery(), see coupled/recovery.h.
  bool recovering = false;
  double law_seconds = 0;   // s: for how long the other law has been called for
  double energy_slack = 0;  // J: what its energy has been above what it is, of late, see energy_guard.h
  // Explicit integrators only; empty and 0 otherwise.
  VecX mode;         // 3n: about the shape of the body's fastest oscillation, unit
  double omega = 0;  // 1/s: about its angular frequency; position-based: substeps a second needed of late, 0:
                     // as described
};

}  // namespace prosector
