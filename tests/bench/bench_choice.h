#pragma once
// Options for benchmarks that choose model configurations by need, as the server does.

#include <string>

#include "server/calibration/choose_scene.h"
#include "server/calibration/rung_meter.h"

namespace prosector {

/// Returns options that cache tables, meshes and trials in `folder`. `meter` must outlive them.
ChoiceOptions choice_options(const std::string& cache, RungMeter& meter);

}  // namespace prosector
