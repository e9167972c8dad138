#pragma once
// One rung under one extreme, and the verdict.

#include <optional>
#include <string>

#include "tests/bench/extreme.h"
#include "tests/bench/report.h"
#include "tests/bench/stability_rungs.h"

namespace prosector {

/// Survives: finite at every step, the total energy never more than 1 % above its start (of the largest
/// kinetic plus elastic energy there was), and back within 1 mm of the rest shape (see misfit), up to a rigid
/// motion, 5 s after the release (where the extreme asks for that). Degrades: a step reported a reset or
/// another loss, or the shape was not back and the last step said that it had not converged. Refuses:
/// InputError before the first step. Fails: anything else.
struct StabilityResult {
  std::optional<Verdict> verdict;  // none: stopped after the time it was given
  std::string reason;
  bool met_deadline = true;  // ms_per_frame is at most what it stands for
  std::size_t tets = 0, nodes = 0;
  double ms_per_frame = 0, worst_ms_per_frame = 0;  // CPU, of 1/60 s or one step if that is longer
  double steps_per_s = 0;                           // CPU, likewise
  double energy_excess = 0;                         // share, see above
  double shape_error = 0;                           // m, see misfit, at the end
  double back_after_s = -1;                         // s after the release; −1: not back within 1 mm
  int resets = 0, refusals = 0, losses = 0;         // steps that reported one; losses: of another kind
  int guarded = 0;                                  // steps taken again or shortened
  int recoveries = 0;                               // times that the recovery law took over
  int steps = 0, steps_not_converged = 0;
  double residual = 0;  // largest
};

StabilityResult run_extreme(const StabilityRung& rung, const Extreme& extreme, double limit_ms);

}  // namespace prosector
