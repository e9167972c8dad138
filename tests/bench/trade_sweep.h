#pragma once
// Which rungs, resolutions, steps and iterations a case is run with.

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
/// Not the whole product: for each model and element, every solver (where a ball presses, the iterative ones)
/// at every effort and resolution with the first integrator and a frame's step; then every integrator (on
/// quadratic elements, every implicit one) at every step, on the coarsest mesh with the first solver.
/// `quick`: the two coarsest resolutions and steps.
std::vector<Trial> trials(const TradeCase& which, bool quick);

struct BulletTrial {
  BulletRung rung;
  unsigned cells;
  double dt;  // s
};
/// None where a ball presses.
std::vector<BulletTrial> bullet_trials(const TradeCase& which, bool quick);

}  // namespace prosector
