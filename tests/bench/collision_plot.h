#pragma once
// Plot of bench_collision: cost and errors of each fidelity, and scaling.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

Svg draw_collision(const std::vector<ReportRow>& rows);

}  // namespace prosector
