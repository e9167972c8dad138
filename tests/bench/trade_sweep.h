#pragma once
// Configurations, resolutions, time steps and iterations that a case is run with.

#include <vector>

#include "server/calibration/rung.h"
#include "tests/bench/bullet_specimen.h"
#include "tests/bench/trade_case.h"

namespace prosector {

struct Trial {
  Rung rung;
  unsigned cells;
  double dt;  // s
};
/// Returns the runs of a case. For each model and element: every solver (only the iterative ones if a ball
/// presses) at every effort and resolution, with the first integrator and a step of 1/60 s; then every
/// integrator (only the implicit ones on quadratic elements) at every step, on the coarsest mesh with the
/// first solver. `quick`: the two coarsest resolutions and steps.
std::vector<Trial> trials(const TradeCase& which, bool quick);

struct BulletTrial {
  BulletRung rung;
  unsigned cells;
  double dt;  // s
};
/// Returns the runs with Bullet's soft bodies; none if a ball presses.
std::vector<BulletTrial> bullet_trials(const TradeCase& which, bool quick);

}  // namespace prosector
