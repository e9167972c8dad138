#pragma once
// Plot of bench_estimate: estimated error against true error.

#include <vector>

#include "tests/bench/report.h"
#include "tests/bench/svg.h"

namespace prosector {

/// Target range of the estimated over the true error.
inline constexpr double least_effectivity = 0.8, most_effectivity = 1.5;

Svg draw_estimates(const std::vector<ReportRow>& rows);

}  // namespace prosector
