#pragma once
// A face of ours before the camera at a screen: how far off the way from the eyes to the screen's middle is
// found, by distance, turn, motion, light and resolution.

#include <functional>

#include "tests/bench/report.h"

namespace prosector {

/// Measures, row by row, and hands each to `take`. Says so and hands out nothing where the network isn't
/// there. `quick`: few pictures.
void measure_faces(bool quick, const std::function<void(const ReportRow&)>& take);

}  // namespace prosector
