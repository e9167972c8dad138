#pragma once
// bench_camera's pictures.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Draws errors of depth over distance, one line a board.
Svg draw_by_distance(const std::vector<ReportRow>& rows);
/// Draws how often boards are found over the speed that blurs them.
Svg draw_by_speed(const std::vector<ReportRow>& rows);

}  // namespace prosector
