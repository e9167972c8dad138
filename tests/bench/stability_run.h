#pragma once
// Runs one configuration under one extreme and judges it.

#include <optional>
#include <string>

#include "tests/bench/extreme.h"
#include "tests/bench/report.h"
#include "tests/bench/stability_rungs.h"

namespace prosector {

/// Result of a stability test. Survives: the state is finite after every step; the total energy never exceeds
/// its initial value by more than 1 % of the largest kinetic plus elastic energy; and 5 s after the release,
/// if the extreme requires recovery, the shape error (see misfit) is within 1 mm. Degrades: a step reported a
/// reset or another loss, or the shape did not recover and the last step reported that it had not converged.
/// Refuses: InputError before the first step. Fails: anything else.
struct StabilityResult {
  std::optional<Verdict> verdict;  // none: stopped at the time limit
  std::string reason;
  bool met_deadline = true;  // whether ms_per_frame is at most its simulated time
  std::size_t tets = 0, nodes = 0;
  double ms_per_frame = 0, worst_ms_per_frame = 0;  // CPU time per 1/60 s, or per step if that is longer
  double steps_per_s = 0;                           // from CPU time
  double energy_excess = 0;                         // fraction, see above
  double shape_error = 0;                           // m, at the end (see misfit)
  double back_after_s = -1;                  // s from release to recovery within 1 mm; −1: not recovered
  int resets = 0, refusals = 0, losses = 0;  // steps that reported a reset, a refusal, another loss
  int guarded = 0;                           // steps repeated or shortened by the energy safeguard
  int recoveries = 0;                        // number of switches to the recovery law
  int steps = 0, steps_not_converged = 0;
  double residual = 0;  // largest relative residual
};

/// Runs the test; stops it after `limit_ms` of CPU time.
StabilityResult run_extreme(const StabilityRung& rung, const Extreme& extreme, double limit_ms);

}  // namespace prosector
