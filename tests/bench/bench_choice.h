#pragma once
// Rungs chosen by need, as the server chooses them, for benches.

#include <string>

#include "server/calibration/choose_scene.h"
#include "server/calibration/rung_meter.h"

namespace prosector {

/// Returns options that keep tables, meshes and trials in that folder. `meter` must outlive them.
ChoiceOptions choice_options(const std::string& cache, RungMeter& meter);

}  // namespace prosector
