#pragma once
// Plots of bench_camera.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Plots the depth error over distance, one line per board.
Svg draw_by_distance(const std::vector<ReportRow>& rows);
/// Plots the detection rate of boards over their speed (motion blur).
Svg draw_by_speed(const std::vector<ReportRow>& rows);

}  // namespace prosector
